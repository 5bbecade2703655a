-- 007: lots of every process. What was open or closed before keeps its rows; who opened it is read from the log. A part says
-- which revision of the recipe it was cut with, as the engine brings it back; of a part of before that is not known.

-- statement: the tool or insert a lot is cut with, '' not said
ALTER TABLE lots ADD COLUMN tool TEXT NOT NULL DEFAULT '';

-- statement: the gauge its parts are measured with, '' not said
ALTER TABLE lots ADD COLUMN gauge TEXT NOT NULL DEFAULT '';

-- statement: who opened it
ALTER TABLE lots ADD COLUMN opened_by TEXT NOT NULL DEFAULT '';

-- statement: who closed it, '' while it is open
ALTER TABLE lots ADD COLUMN closed_by TEXT NOT NULL DEFAULT '';

-- statement: as the log has it
UPDATE lots SET opened_by = coalesce((SELECT author FROM audit WHERE object = 'lot' AND action = 'lot opened' AND
                                      object_id = lots.id ORDER BY id LIMIT 1), ''),
                closed_by = coalesce((SELECT author FROM audit WHERE object = 'lot' AND action = 'lot closed' AND
                                      object_id = lots.id ORDER BY id LIMIT 1), '');

-- statement: which revision a part was cut with; empty: made before this step, or with what the program brings along
ALTER TABLE parts ADD COLUMN recipe_revision_id INTEGER REFERENCES recipe_revisions (id);

-- statement: SHA-256 over the part before and what is kept of this one; parts of before this step have none
ALTER TABLE parts ADD COLUMN seal TEXT;

-- statement: parts of a recipe that are of no lot
CREATE INDEX parts_by_recipe ON parts (recipe_revision_id) WHERE lot_id IS NULL AND recipe_revision_id IS NOT NULL;

-- statement: of a lot only its end is added
CREATE TRIGGER lots_only_closed BEFORE UPDATE OF id, machine_id, part_type_id, recipe_revision_id, name, size, estimator,
    opened_utc_ms, tool, gauge, opened_by ON lots
BEGIN
    SELECT RAISE(ABORT, 'lots is append-only');
END;

-- statement: a lot is closed once
CREATE TRIGGER lots_closed_once BEFORE UPDATE ON lots WHEN OLD.closed_utc_ms IS NOT NULL
BEGIN
    SELECT RAISE(ABORT, 'lots is append-only');
END;

-- statement: lots are never deleted
CREATE TRIGGER lots_no_delete BEFORE DELETE ON lots
BEGIN
    SELECT RAISE(ABORT, 'lots is append-only');
END;

-- statement: of a part only the serial number is changed, which the log notes
CREATE TRIGGER parts_only_serial BEFORE UPDATE OF id, process, lot_id, number, complete, machine_begin_ns, machine_end_ns,
    ended_utc_ms, schedule_id, recipe_revision_id, seal ON parts
BEGIN
    SELECT RAISE(ABORT, 'parts is append-only');
END;

-- statement: parts are never deleted
CREATE TRIGGER parts_no_delete BEFORE DELETE ON parts
BEGIN
    SELECT RAISE(ABORT, 'parts is append-only');
END;

-- statement: figures are never changed
CREATE TRIGGER part_results_no_update BEFORE UPDATE ON part_results
BEGIN
    SELECT RAISE(ABORT, 'part_results is append-only');
END;

-- statement: figures are never deleted
CREATE TRIGGER part_results_no_delete BEFORE DELETE ON part_results
BEGIN
    SELECT RAISE(ABORT, 'part_results is append-only');
END;
