-- 006: setups, limits and tunings become recipes like boring's: a part type of their process, a revision for each that was
-- accepted, in their order, with author, reason and time. The room records they were stay where they are.

-- statement: room records that are revisions of a recipe, numbered within their part type. A milled part type that was chosen
-- and never given a setup of its own begins with the one it was chosen with. `verify` reads it again: what was brought along
-- has no entry of its own in the log, that of its record stands for it.
CREATE VIEW kept_recipes AS
WITH chosen AS (SELECT subject, min(id) AS first FROM room_records
                 WHERE process = 'milling' AND kind = 'part_type' AND body <> '{}' GROUP BY subject),
     saved AS (SELECT subject, min(id) AS first FROM room_records
                WHERE process = 'milling' AND kind = 'setup' GROUP BY subject),
     kept AS (SELECT id FROM room_records WHERE process = 'milling' AND kind = 'setup'
              UNION ALL SELECT c.first FROM chosen c LEFT JOIN saved s ON s.subject = c.subject
                         WHERE s.first IS NULL OR s.first > c.first
              UNION ALL SELECT id FROM room_records WHERE process = 'turning' AND kind = 'setup'
              UNION ALL SELECT id FROM room_records WHERE process = 'thermal' AND kind = 'setup'
              UNION ALL SELECT id FROM room_records WHERE process = 'tapping' AND kind = 'tuning'),
     named AS (SELECT o.id, o.process, o.body, o.author, o.reason, o.created_utc_ms,
                      CASE WHEN o.subject <> '' THEN o.subject
                           WHEN o.process = 'turning' THEN 'Face'
                           ELSE 'Machine' END AS name
                 FROM kept k JOIN room_records o ON o.id = k.id)
SELECT id AS room_record_id, process, name, row_number() OVER (PARTITION BY process, name ORDER BY id) AS ordinal,
       body, author, reason, created_utc_ms
  FROM named;

-- statement: their part types, each since its first record
INSERT INTO part_types (process, name, created_utc_ms)
SELECT process, name, created_utc_ms FROM kept_recipes WHERE ordinal = 1 ORDER BY room_record_id
ON CONFLICT (process, name) DO NOTHING;

-- statement: the revisions, in the order in which they were accepted
INSERT INTO recipe_revisions (part_type_id, revision, parameters, author, reason, created_utc_ms)
SELECT t.id, coalesce((SELECT max(r.revision) FROM recipe_revisions r WHERE r.part_type_id = t.id), 0) + k.ordinal,
       k.body, k.author, k.reason, k.created_utc_ms
  FROM kept_recipes k JOIN part_types t ON t.process = k.process AND t.name = k.name
 ORDER BY k.room_record_id;
