-- 002: figures of parts of every process, and what the rooms keep (setups, tunings, models).

-- statement: a part's figures as the engine found them; a JSON object, keys end in their unit
CREATE TABLE part_results (
    part_id INTEGER PRIMARY KEY REFERENCES parts (id),
    results TEXT NOT NULL CHECK (json_valid(results))
) STRICT;

-- statement: parts of no lot are numbered per process
CREATE INDEX parts_without_lot ON parts (process, number) WHERE lot_id IS NULL;

-- statement: values a room keeps for ever; the newest of its process, kind and subject holds
CREATE TABLE room_records (
    id             INTEGER PRIMARY KEY AUTOINCREMENT,
    process        TEXT NOT NULL,
    kind           TEXT NOT NULL CHECK (kind <> ''),
    subject        TEXT NOT NULL,
    body           TEXT NOT NULL CHECK (json_valid(body)),
    author         TEXT NOT NULL CHECK (author <> ''),
    reason         TEXT NOT NULL,
    created_utc_ms INTEGER NOT NULL
) STRICT;

-- statement: newest of a kind first
CREATE INDEX room_records_by_kind ON room_records (process, kind, id);

-- statement: room records are never changed
CREATE TRIGGER room_records_no_update BEFORE UPDATE ON room_records
BEGIN
    SELECT RAISE(ABORT, 'room_records is append-only');
END;

-- statement: room records are never deleted
CREATE TRIGGER room_records_no_delete BEFORE DELETE ON room_records
BEGIN
    SELECT RAISE(ABORT, 'room_records is append-only');
END;
