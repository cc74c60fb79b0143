return {map_builder = {pose_graph = {huber_scale = 0/0, [1] = 2, [{}] = function() end}}}
