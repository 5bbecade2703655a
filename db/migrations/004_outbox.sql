-- 004: the shop's outbox. What changes is noted here in the same transaction, for a server that may be far away or not there.

-- statement: who this data file is; a restored backup or a cloned folder begins a new epoch, the newest row holds
CREATE TABLE shop_epochs (
    id           INTEGER PRIMARY KEY AUTOINCREMENT,
    store        TEXT NOT NULL,
    epoch        TEXT NOT NULL UNIQUE,
    reason       TEXT NOT NULL,
    began_utc_ms INTEGER NOT NULL
) STRICT;

-- statement: epochs are never changed
CREATE TRIGGER shop_epochs_no_update BEFORE UPDATE ON shop_epochs
BEGIN
    SELECT RAISE(ABORT, 'shop_epochs is append-only');
END;

-- statement: epochs are never deleted
CREATE TRIGGER shop_epochs_no_delete BEFORE DELETE ON shop_epochs
BEGIN
    SELECT RAISE(ABORT, 'shop_epochs is append-only');
END;

-- statement: the first epoch
INSERT INTO shop_epochs (store, epoch, reason, began_utc_ms)
WITH words AS MATERIALIZED (SELECT lower(hex(randomblob(16))) AS s, lower(hex(randomblob(16))) AS e)
SELECT substr(s, 1, 8) || '-' || substr(s, 9, 4) || '-4' || substr(s, 14, 3) || '-8' || substr(s, 18, 3) || '-' || substr(s, 21),
       substr(e, 1, 8) || '-' || substr(e, 9, 4) || '-4' || substr(e, 14, 3) || '-8' || substr(e, 18, 3) || '-' || substr(e, 21),
       'first', CAST(strftime('%s', 'now') AS INTEGER) * 1000
  FROM words;

-- statement: which row changed, in order; the mark is drawn by lot, so that two histories never look alike
CREATE TABLE outbox (
    seq        INTEGER PRIMARY KEY AUTOINCREMENT,
    table_name TEXT NOT NULL,
    row_key    ANY NOT NULL,
    mark       INTEGER NOT NULL DEFAULT (random())
) STRICT;

-- statement: feed traces are large and go with lower priority, on a numbering of their own
CREATE TABLE outbox_traces (
    seq     INTEGER PRIMARY KEY AUTOINCREMENT,
    row_key INTEGER NOT NULL,
    mark    INTEGER NOT NULL DEFAULT (random())
) STRICT;

-- statement: machines that are there already
INSERT INTO outbox (table_name, row_key) SELECT 'machines', id FROM machines ORDER BY id;

-- statement: part types that are there already
INSERT INTO outbox (table_name, row_key) SELECT 'part_types', id FROM part_types ORDER BY id;

-- statement: recipe revisions that are there already
INSERT INTO outbox (table_name, row_key) SELECT 'recipe_revisions', id FROM recipe_revisions ORDER BY id;

-- statement: lots that are there already
INSERT INTO outbox (table_name, row_key) SELECT 'lots', id FROM lots ORDER BY id;

-- statement: schedules that are there already
INSERT INTO outbox (table_name, row_key) SELECT 'schedules', id FROM schedules ORDER BY id;

-- statement: parts that are there already
INSERT INTO outbox (table_name, row_key) SELECT 'parts', id FROM parts ORDER BY id;

-- statement: part results that are there already
INSERT INTO outbox (table_name, row_key) SELECT 'part_results', part_id FROM part_results ORDER BY part_id;

-- statement: measurements that are there already
INSERT INTO outbox (table_name, row_key) SELECT 'measurements', id FROM measurements ORDER BY id;

-- statement: estimator states that are there already
INSERT INTO outbox (table_name, row_key) SELECT 'estimator_states', id FROM estimator_states ORDER BY id;

-- statement: alarms that are there already
INSERT INTO outbox (table_name, row_key) SELECT 'alarms', id FROM alarms ORDER BY id;

-- statement: settings that are there already
INSERT INTO outbox (table_name, row_key) SELECT 'settings', key FROM settings WHERE key <> 'operators' ORDER BY key;

-- statement: audit that are there already
INSERT INTO outbox (table_name, row_key) SELECT 'audit', id FROM audit WHERE object <> 'setting operators' ORDER BY id;

-- statement: room records that are there already
INSERT INTO outbox (table_name, row_key) SELECT 'room_records', id FROM room_records ORDER BY id;

-- statement: feed traces that are there already
INSERT INTO outbox_traces (row_key) SELECT part_id FROM feed_traces ORDER BY part_id;

-- statement: new machines
CREATE TRIGGER machines_outbox_insert AFTER INSERT ON machines
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('machines', NEW.id);
END;

-- statement: changed machines
CREATE TRIGGER machines_outbox_update AFTER UPDATE ON machines
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('machines', NEW.id);
END;

-- statement: new part types
CREATE TRIGGER part_types_outbox_insert AFTER INSERT ON part_types
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('part_types', NEW.id);
END;

-- statement: changed part types
CREATE TRIGGER part_types_outbox_update AFTER UPDATE ON part_types
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('part_types', NEW.id);
END;

-- statement: new recipe revisions
CREATE TRIGGER recipe_revisions_outbox_insert AFTER INSERT ON recipe_revisions
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('recipe_revisions', NEW.id);
END;

-- statement: new lots
CREATE TRIGGER lots_outbox_insert AFTER INSERT ON lots
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('lots', NEW.id);
END;

-- statement: changed lots
CREATE TRIGGER lots_outbox_update AFTER UPDATE ON lots
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('lots', NEW.id);
END;

-- statement: new schedules
CREATE TRIGGER schedules_outbox_insert AFTER INSERT ON schedules
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('schedules', NEW.id);
END;

-- statement: changed schedules
CREATE TRIGGER schedules_outbox_update AFTER UPDATE ON schedules
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('schedules', NEW.id);
END;

-- statement: new parts
CREATE TRIGGER parts_outbox_insert AFTER INSERT ON parts
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('parts', NEW.id);
END;

-- statement: changed parts
CREATE TRIGGER parts_outbox_update AFTER UPDATE ON parts
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('parts', NEW.id);
END;

-- statement: new part results
CREATE TRIGGER part_results_outbox_insert AFTER INSERT ON part_results
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('part_results', NEW.part_id);
END;

-- statement: new measurements
CREATE TRIGGER measurements_outbox_insert AFTER INSERT ON measurements
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('measurements', NEW.id);
END;

-- statement: new estimator states
CREATE TRIGGER estimator_states_outbox_insert AFTER INSERT ON estimator_states
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('estimator_states', NEW.id);
END;

-- statement: new alarms
CREATE TRIGGER alarms_outbox_insert AFTER INSERT ON alarms
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('alarms', NEW.id);
END;

-- statement: changed alarms
CREATE TRIGGER alarms_outbox_update AFTER UPDATE ON alarms
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('alarms', NEW.id);
END;

-- statement: new settings; sealed PINs stay here
CREATE TRIGGER settings_outbox_insert AFTER INSERT ON settings
WHEN NEW.key <> 'operators'
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('settings', NEW.key);
END;

-- statement: changed settings; sealed PINs stay here
CREATE TRIGGER settings_outbox_update AFTER UPDATE ON settings
WHEN NEW.key <> 'operators'
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('settings', NEW.key);
END;

-- statement: new audit; sealed PINs stay here
CREATE TRIGGER audit_outbox_insert AFTER INSERT ON audit
WHEN NEW.object <> 'setting operators'
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('audit', NEW.id);
END;

-- statement: new room records
CREATE TRIGGER room_records_outbox_insert AFTER INSERT ON room_records
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('room_records', NEW.id);
END;

-- statement: new feed traces
CREATE TRIGGER feed_traces_outbox_insert AFTER INSERT ON feed_traces
BEGIN
    INSERT INTO outbox_traces (row_key) VALUES (NEW.part_id);
END;
