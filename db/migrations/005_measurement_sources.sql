-- 005: where each measured value came from, beside it: keypad, which gauge, which file. What was accepted before this step
-- has no row here; of it only keypad or gauge is known (measurements.source).

-- statement: one row per measurement, stored in its transaction; name: the gauge's identity or the file's name, '' not known
CREATE TABLE measurement_sources (
    measurement_id INTEGER PRIMARY KEY REFERENCES measurements (id),
    source         TEXT NOT NULL CHECK (source IN ('keypad', 'gauge', 'file')),
    name           TEXT NOT NULL,
    CHECK (source <> 'file' OR name <> '')
) STRICT;

-- statement: no INSERT OR REPLACE over an old source
CREATE TRIGGER measurement_sources_no_replace BEFORE INSERT ON measurement_sources
WHEN EXISTS (SELECT 1 FROM measurement_sources WHERE measurement_id = NEW.measurement_id)
BEGIN
    SELECT RAISE(ABORT, 'measurement_sources is append-only');
END;

-- statement: sources are never changed
CREATE TRIGGER measurement_sources_no_update BEFORE UPDATE ON measurement_sources
BEGIN
    SELECT RAISE(ABORT, 'measurement_sources is append-only');
END;

-- statement: sources are never deleted
CREATE TRIGGER measurement_sources_no_delete BEFORE DELETE ON measurement_sources
BEGIN
    SELECT RAISE(ABORT, 'measurement_sources is append-only');
END;

-- statement: new sources
CREATE TRIGGER measurement_sources_outbox_insert AFTER INSERT ON measurement_sources
BEGIN
    INSERT INTO outbox (table_name, row_key) VALUES ('measurement_sources', NEW.measurement_id);
END;
