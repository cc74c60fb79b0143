// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/recording_schema.h"

namespace loopscope {

// Columns without a type hold a float64 exactly as it is.
extern const char kRecordingSchema[] = R"sql(
CREATE TABLE log (            -- the log that was mapped; one row
  name TEXT NOT NULL,         -- of the file, without folder
  num_scans INTEGER NOT NULL,
  num_odometry INTEGER NOT NULL,
  laser_x NOT NULL,           -- [m] base_from_laser: where the scanner is on the robot
  laser_y NOT NULL,           -- [m]
  laser_rotation NOT NULL     -- [rad]
);
CREATE TABLE log_note (       -- what the reader of the log corrected or left out
  id INTEGER PRIMARY KEY,
  what TEXT NOT NULL,
  count INTEGER NOT NULL,
  first_line INTEGER NOT NULL
);
CREATE TABLE beam_geometry (
  id INTEGER PRIMARY KEY,     -- from 0
  num_beams INTEGER NOT NULL,
  first_angle NOT NULL,       -- [rad]
  angle_increment NOT NULL    -- [rad]
);
CREATE TABLE scan_chunk (     -- the scans of the log in its order, some in each row
  first_scan INTEGER PRIMARY KEY,
  data BLOB NOT NULL          -- zlib stream, see core/io/scan_codec.h
);
CREATE TABLE odometry_chunk ( -- likewise the raw odometry
  first_reading INTEGER PRIMARY KEY,
  data BLOB NOT NULL
);
CREATE TABLE option (         -- all options of the run
  key TEXT PRIMARY KEY,       -- Cartographer's name
  value TEXT NOT NULL
) WITHOUT ROWID;
CREATE TABLE step (           -- what local SLAM made of a scan
  id INTEGER PRIMARY KEY,     -- index of the scan in the log, from 0
  outcome INTEGER NOT NULL,   -- 0 inserted, 1 motion filtered, 2 no returns
  match_start INTEGER,        -- where its match began: 0 not matched, 1 prediction, 2 velocity in
                              -- place of odometry, 3 wide search, 4 between the scan before
                              -- it and one ahead that matched, 5 nowhere, led by its motions
                              -- before; null if not known
  poses BLOB NOT NULL,        -- local_from_base as extrapolated, after the correlative matcher, and
                              -- as matched, see core/io/step_codec.h
  finished_submap INTEGER,    -- that this scan completed
  wide_walls INTEGER NOT NULL -- 1 if the walls that it was matched against were a cell wider
);
CREATE TABLE node (           -- a scan that was inserted
  id INTEGER PRIMARY KEY,     -- from 0
  step INTEGER NOT NULL,
  first_submap INTEGER NOT NULL,  -- it went into this one
  num_submaps INTEGER NOT NULL,   -- and, if 2, into the next
  x,                          -- [m] local_from_base; null if it is that of the step
  y,                          -- [m]
  rotation                    -- [rad]
);
CREATE TABLE submap (
  id INTEGER PRIMARY KEY,     -- from 0
  step INTEGER NOT NULL,      -- in which it was begun
  first_node INTEGER NOT NULL,
  x NOT NULL,                 -- [m] local_from_submap
  y NOT NULL,                 -- [m]
  rotation NOT NULL           -- [rad]
);
CREATE TABLE loop_candidates (  -- the pairs of node and finished submap that came up
  step INTEGER PRIMARY KEY,   -- in which the results entered the graph
  data BLOB NOT NULL          -- zlib stream, see core/io/candidate_codec.h
);
CREATE TABLE optimization (
  id INTEGER PRIMARY KEY,     -- from 0
  step INTEGER NOT NULL,
  final INTEGER NOT NULL,     -- 1 for the one at the end
  num_iterations INTEGER NOT NULL,
  initial_cost NOT NULL,
  final_cost NOT NULL,
  linear_drift_share NOT NULL,   -- of their windows that searches take from then on
  angular_drift_share NOT NULL,
  data BLOB NOT NULL          -- zlib stream of global_from_submap, global_from_node, each packed as
                              -- in core/io/number_codec.h, predicted by the optimization before
);
CREATE TABLE timing (         -- of a finished run; no result depends on it
  what TEXT PRIMARY KEY,      -- "wall"
  seconds NOT NULL
) WITHOUT ROWID;
)sql";

}  // namespace loopscope
