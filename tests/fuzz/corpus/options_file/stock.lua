include "map_builder.lua"
include "trajectory_builder.lua"
options = {map_builder = MAP_BUILDER, trajectory_builder = TRAJECTORY_BUILDER, use_odometry = true}
MAP_BUILDER.use_trajectory_builder_2d = true
TRAJECTORY_BUILDER_2D.submaps.num_range_data = 35
POSE_GRAPH.constraint_builder.min_score = choose(true, 0.6, 0.5)
TRAJECTORY_BUILDER_2D.motion_filter.max_angle_radians = math.rad(0.2)
return options
