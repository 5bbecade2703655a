-- 008: an acceptance writes fewer pages. No row changes, and no column: indexes that were written with every measurement and
-- hardly ever read give way, and tables of which nothing can be deleted number their rows without SQLite's own list of the
-- highest numbers, whose page was written again with every row (a number is not used again as long as its row stays).

-- statement: states of one measurement are found within those of its lot
DROP INDEX estimator_states_by_measurement;

-- statement: the index by lot alone
DROP INDEX estimator_states_by_lot;

-- statement: states of one lot, and of one measurement of it
CREATE INDEX estimator_states_by_lot ON estimator_states (lot_id, measurement_id);

-- statement: every entry in an index was for what is looked up by its object; measurements never are, they are read in order
DROP INDEX audit_by_object;

-- statement: audit entries of one object; a query says "object <> 'measurement'" for SQLite to use it
CREATE INDEX audit_by_object ON audit (object, object_id) WHERE object <> 'measurement';

-- statement: the words of a table are changed, not what is stored in it (sqlite.org/lang_altertable.html, 7)
PRAGMA writable_schema = ON;

-- statement: triggers keep these from being deleted from, and pointers of the outbox are never deleted
UPDATE sqlite_schema SET sql = replace(sql, 'INTEGER PRIMARY KEY AUTOINCREMENT', 'INTEGER PRIMARY KEY')
 WHERE type = 'table' AND name IN ('measurements', 'estimator_states', 'audit', 'outbox');

-- statement: SQLite reads the words again
PRAGMA writable_schema = RESET;

-- statement: their highest numbers are those of their newest rows
DELETE FROM sqlite_sequence WHERE name IN ('measurements', 'estimator_states', 'audit', 'outbox');
