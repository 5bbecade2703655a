-- 001: the first released schema. Never edited after release; a change is a new numbered file.
--
-- Each block after a "-- statement:" line is exactly one SQL statement (db/migrator.h). Columns end in their unit;
-- instants are milliseconds since 1970-01-01 UTC (…_utc_ms), machine time is nanoseconds since the engine started.

-- statement: which schema step was applied when, by which version of the program
CREATE TABLE schema_steps (
    version        INTEGER PRIMARY KEY,
    applied_utc_ms INTEGER NOT NULL,
    program        TEXT NOT NULL
) STRICT;

-- statement: machines
CREATE TABLE machines (
    id             INTEGER PRIMARY KEY,
    name           TEXT NOT NULL UNIQUE CHECK (name <> ''),
    kind           TEXT NOT NULL CHECK (kind <> ''),
    created_utc_ms INTEGER NOT NULL
) STRICT;

-- statement: part types; what is made
CREATE TABLE part_types (
    id             INTEGER PRIMARY KEY,
    process        TEXT NOT NULL,
    name           TEXT NOT NULL CHECK (name <> ''),
    created_utc_ms INTEGER NOT NULL,
    UNIQUE (process, name)
) STRICT;

-- statement: recipes; every revision of a part type's parameters stays
CREATE TABLE recipe_revisions (
    id             INTEGER PRIMARY KEY AUTOINCREMENT,
    part_type_id   INTEGER NOT NULL REFERENCES part_types (id),
    revision       INTEGER NOT NULL CHECK (revision >= 1),
    parameters     TEXT NOT NULL CHECK (json_valid(parameters)),
    restored_from  INTEGER,
    author         TEXT NOT NULL CHECK (author <> ''),
    reason         TEXT NOT NULL,
    created_utc_ms INTEGER NOT NULL,
    UNIQUE (part_type_id, revision)
) STRICT;

-- statement: recipe revisions are never changed
CREATE TRIGGER recipe_revisions_no_update BEFORE UPDATE ON recipe_revisions
BEGIN
    SELECT RAISE(ABORT, 'recipe_revisions is append-only');
END;

-- statement: recipe revisions are never deleted
CREATE TRIGGER recipe_revisions_no_delete BEFORE DELETE ON recipe_revisions
BEGIN
    SELECT RAISE(ABORT, 'recipe_revisions is append-only');
END;

-- statement: lots
CREATE TABLE lots (
    id                 INTEGER PRIMARY KEY,
    machine_id         INTEGER NOT NULL REFERENCES machines (id),
    part_type_id       INTEGER NOT NULL REFERENCES part_types (id),
    recipe_revision_id INTEGER NOT NULL REFERENCES recipe_revisions (id),
    name               TEXT NOT NULL CHECK (name <> ''),
    size               INTEGER NOT NULL CHECK (size >= 0),
    estimator          TEXT NOT NULL,
    opened_utc_ms      INTEGER NOT NULL,
    closed_utc_ms      INTEGER,
    UNIQUE (machine_id, part_type_id, name)
) STRICT;

-- statement: lots of one part type
CREATE INDEX lots_by_part_type ON lots (part_type_id);

-- statement: boring schedules; one row per revision that was proposed or cut with
CREATE TABLE schedules (
    id                         INTEGER PRIMARY KEY,
    lot_id                     INTEGER REFERENCES lots (id),
    revision                   INTEGER NOT NULL,
    ln_c                       REAL NOT NULL,
    alpha                      REAL NOT NULL,
    beta                       REAL NOT NULL,
    target_deflection_mm       REAL NOT NULL,
    constant_feed_mm_per_rev   REAL NOT NULL,
    min_feed_mm_per_rev        REAL NOT NULL,
    max_feed_mm_per_rev        REAL NOT NULL,
    overhang_from_mm           REAL NOT NULL,
    overhang_to_mm             REAL NOT NULL,
    spindle_speed_rpm          REAL NOT NULL,
    prediction                 TEXT NOT NULL DEFAULT '' CHECK (prediction = '' OR json_valid(prediction)),
    reason                     TEXT NOT NULL DEFAULT '',
    created_utc_ms             INTEGER NOT NULL,
    accepted_by                TEXT NOT NULL DEFAULT '',
    accepted_utc_ms            INTEGER
) STRICT;

-- statement: schedules of one lot
CREATE INDEX schedules_by_lot ON schedules (lot_id, revision);

-- statement: parts
CREATE TABLE parts (
    id               INTEGER PRIMARY KEY AUTOINCREMENT,
    process          TEXT NOT NULL,
    lot_id           INTEGER REFERENCES lots (id),
    number           INTEGER NOT NULL CHECK (number >= 1),
    serial           TEXT COLLATE NOCASE CHECK (serial <> ''),
    complete         INTEGER NOT NULL CHECK (complete IN (0, 1)),
    machine_begin_ns INTEGER NOT NULL,
    machine_end_ns   INTEGER NOT NULL CHECK (machine_end_ns >= machine_begin_ns),
    ended_utc_ms     INTEGER NOT NULL,
    schedule_id      INTEGER REFERENCES schedules (id)
) STRICT;

-- statement: a part's number is unique in its lot
CREATE UNIQUE INDEX parts_by_lot ON parts (lot_id, number);

-- statement: parts by process, newest last
CREATE INDEX parts_by_process ON parts (process);

-- statement: parts by time
CREATE INDEX parts_by_time ON parts (ended_utc_ms);

-- statement: parts by serial number
CREATE INDEX parts_by_serial ON parts (serial) WHERE serial IS NOT NULL;

-- statement: the really cut feed; points are pairs of little-endian 32-bit floats (overhang mm, feed mm/rev)
CREATE TABLE feed_traces (
    part_id INTEGER PRIMARY KEY REFERENCES parts (id),
    points  BLOB NOT NULL
) STRICT;

-- statement: measurements in the order they were accepted; a correction or void points to the row it replaces
CREATE TABLE measurements (
    id              INTEGER PRIMARY KEY AUTOINCREMENT,
    part_id         INTEGER NOT NULL REFERENCES parts (id),
    kind            TEXT NOT NULL CHECK (kind IN ('entry', 'correction', 'void')),
    replaces_id     INTEGER REFERENCES measurements (id),
    station         INTEGER NOT NULL CHECK (station BETWEEN 0 AND 255),
    position_mm     REAL NOT NULL,
    diameter_mm     REAL CHECK (diameter_mm > 0),
    source          TEXT NOT NULL CHECK (source IN ('keypad', 'gauge')),
    confirmed       INTEGER NOT NULL CHECK (confirmed IN (0, 1)),
    author          TEXT NOT NULL CHECK (author <> ''),
    reason          TEXT NOT NULL,
    accepted_utc_ms INTEGER NOT NULL,
    CHECK ((kind = 'entry') = (replaces_id IS NULL)),
    CHECK ((kind = 'void') = (diameter_mm IS NULL)),
    CHECK (kind = 'entry' OR reason <> '')
) STRICT;

-- statement: measurements of one part
CREATE INDEX measurements_by_part ON measurements (part_id);

-- statement: a row is replaced at most once, so that corrections form a chain
CREATE UNIQUE INDEX measurements_replaced_once ON measurements (replaces_id) WHERE replaces_id IS NOT NULL;

-- statement: a replacement stays at the part and station of what it replaces
CREATE TRIGGER measurements_same_place BEFORE INSERT ON measurements
WHEN NEW.replaces_id IS NOT NULL AND NOT EXISTS (
    SELECT 1 FROM measurements WHERE id = NEW.replaces_id AND part_id = NEW.part_id AND station = NEW.station)
BEGIN
    SELECT RAISE(ABORT, 'a correction belongs to the same part and station');
END;

-- statement: no INSERT OR REPLACE over an old measurement
CREATE TRIGGER measurements_no_replace BEFORE INSERT ON measurements
WHEN EXISTS (SELECT 1 FROM measurements WHERE id = NEW.id)
BEGIN
    SELECT RAISE(ABORT, 'measurements is append-only');
END;

-- statement: measurements are never changed
CREATE TRIGGER measurements_no_update BEFORE UPDATE ON measurements
BEGIN
    SELECT RAISE(ABORT, 'measurements is append-only');
END;

-- statement: measurements are never deleted
CREATE TRIGGER measurements_no_delete BEFORE DELETE ON measurements
BEGIN
    SELECT RAISE(ABORT, 'measurements is append-only');
END;

-- statement: estimator after a measurement; a recomputation adds rows, the newest of a measurement holds
CREATE TABLE estimator_states (
    id                   INTEGER PRIMARY KEY AUTOINCREMENT,
    lot_id               INTEGER NOT NULL REFERENCES lots (id),
    measurement_id       INTEGER NOT NULL REFERENCES measurements (id),
    cause_measurement_id INTEGER NOT NULL REFERENCES measurements (id),
    estimator            TEXT NOT NULL,
    ln_c                 REAL NOT NULL,
    alpha                REAL NOT NULL,
    beta                 REAL NOT NULL,
    p00                  REAL NOT NULL,
    p01                  REAL NOT NULL,
    p02                  REAL NOT NULL,
    p11                  REAL NOT NULL,
    p12                  REAL NOT NULL,
    p22                  REAL NOT NULL,
    perturbed            INTEGER NOT NULL CHECK (perturbed IN (0, 1)),
    state                TEXT NOT NULL CHECK (json_valid(state))
) STRICT;

-- statement: states of one measurement
CREATE INDEX estimator_states_by_measurement ON estimator_states (measurement_id);

-- statement: states of one lot
CREATE INDEX estimator_states_by_lot ON estimator_states (lot_id);

-- statement: estimator states are never changed
CREATE TRIGGER estimator_states_no_update BEFORE UPDATE ON estimator_states
BEGIN
    SELECT RAISE(ABORT, 'estimator_states is append-only');
END;

-- statement: estimator states are never deleted
CREATE TRIGGER estimator_states_no_delete BEFORE DELETE ON estimator_states
BEGIN
    SELECT RAISE(ABORT, 'estimator_states is append-only');
END;

-- statement: alarms; one row per occurrence
CREATE TABLE alarms (
    id                  INTEGER PRIMARY KEY AUTOINCREMENT,
    code                INTEGER NOT NULL,
    priority            INTEGER NOT NULL,
    raised_utc_ms       INTEGER NOT NULL,
    cleared_utc_ms      INTEGER,
    clear_cause         TEXT CHECK (clear_cause IN ('gone', 'restart')),
    acknowledged_utc_ms INTEGER,
    acknowledged_by     TEXT NOT NULL DEFAULT '',
    detail_text         TEXT NOT NULL,
    detail_args         TEXT NOT NULL CHECK (json_valid(detail_args)),
    CHECK ((cleared_utc_ms IS NULL) = (clear_cause IS NULL)),
    CHECK ((acknowledged_utc_ms IS NULL) = (acknowledged_by = ''))
) STRICT;

-- statement: alarms that still stand
CREATE INDEX alarms_open ON alarms (code) WHERE cleared_utc_ms IS NULL;

-- statement: settings; the newest value, its history is in the audit log
CREATE TABLE settings (
    key            TEXT PRIMARY KEY CHECK (key <> ''),
    value          TEXT NOT NULL,
    changed_by     TEXT NOT NULL,
    changed_utc_ms INTEGER NOT NULL
) STRICT, WITHOUT ROWID;

-- statement: who changed what, when, from what to what, and why; chained by SHA-256
CREATE TABLE audit (
    id            INTEGER PRIMARY KEY AUTOINCREMENT,
    utc_ms        INTEGER NOT NULL,
    author        TEXT NOT NULL CHECK (author <> ''),
    action        TEXT NOT NULL,
    object        TEXT NOT NULL,
    object_id     INTEGER NOT NULL,
    old_value     TEXT NOT NULL,
    new_value     TEXT NOT NULL,
    reason        TEXT NOT NULL,
    previous_hash TEXT NOT NULL,
    hash          TEXT NOT NULL
) STRICT;

-- statement: audit entries of one object
CREATE INDEX audit_by_object ON audit (object, object_id);

-- statement: no INSERT OR REPLACE over an old audit entry
CREATE TRIGGER audit_no_replace BEFORE INSERT ON audit
WHEN EXISTS (SELECT 1 FROM audit WHERE id = NEW.id)
BEGIN
    SELECT RAISE(ABORT, 'audit is append-only');
END;

-- statement: audit entries are never changed
CREATE TRIGGER audit_no_update BEFORE UPDATE ON audit
BEGIN
    SELECT RAISE(ABORT, 'audit is append-only');
END;

-- statement: audit entries are never deleted
CREATE TRIGGER audit_no_delete BEFORE DELETE ON audit
BEGIN
    SELECT RAISE(ABORT, 'audit is append-only');
END;
