-- What a console's role and a reader may do. Variables: store, role. Rolled back at its end.
BEGIN;
CREATE EXTENSION IF NOT EXISTS pgtap;
SELECT plan(20);

SELECT set_config('kerf.store', :'store', true);
CREATE ROLE other_console LOGIN IN ROLE kerf_console;
INSERT INTO shop.enrolled (store, role, console) VALUES ('11111111-1111-4111-8111-111111111111', 'other_console', 'other');
CREATE ROLE stranger LOGIN;
CREATE ROLE reader_all LOGIN IN ROLE kerf_reader;
CREATE ROLE reader_one LOGIN IN ROLE kerf_reader;
INSERT INTO shop.reader_stores SELECT 'reader_one', store FROM shop.stores ORDER BY store LIMIT 1;
CREATE TEMP TABLE all_stores AS SELECT count(*)::int AS n FROM shop.stores;
GRANT SELECT ON all_stores TO PUBLIC;
-- pgTAP keeps its count in temporary tables of whoever began.
GRANT ALL ON ALL TABLES IN SCHEMA public TO PUBLIC;
DO $$ BEGIN EXECUTE (SELECT string_agg(format('GRANT ALL ON pg_temp.%I TO PUBLIC', relname), ';') FROM pg_class
    WHERE relnamespace = pg_my_temp_schema() AND relkind IN ('r', 'S') AND relname <> 'all_stores'); END $$;

SET SESSION AUTHORIZATION :"role";
SELECT lives_ok(format($$SELECT shop.ingest(%L, '22222222-2222-4222-8222-222222222222', 0,
    '{"hello": {"reason": "first", "began_utc_ms": 1, "program": "t", "utc_ms": 1}}')$$, current_setting('kerf.store')),
    'a console pushes its own store');
SELECT throws_ok($$SELECT shop.ingest('11111111-1111-4111-8111-111111111111', '22222222-2222-4222-8222-222222222222', 0, '{"hello": {}}')$$,
    '42501', NULL, 'not that of another');
SELECT throws_ok($$SELECT shop.ingest('33333333-3333-4333-8333-333333333333', '22222222-2222-4222-8222-222222222222', 0, '{"hello": {}}')$$,
    '42501', NULL, 'nor one that nobody has enrolled');
SELECT throws_ok('SELECT * FROM shop.parts', '42501', NULL, 'a console reads no parts');
SELECT throws_ok('SELECT * FROM shop.stores', '42501', NULL, 'no stores');
SELECT throws_ok('SELECT * FROM shop.consoles', '42501', NULL, 'no views');
SELECT throws_ok('DELETE FROM shop.measurements', '42501', NULL, 'deletes nothing');
SELECT throws_ok('UPDATE shop.streams SET last_seq = 0', '42501', NULL, 'moves no number');
SELECT throws_ok('INSERT INTO shop.enrolled VALUES (gen_random_uuid(), current_user, ''x'')', '42501', NULL, 'enrols nobody');
SELECT throws_ok('CREATE TABLE shop.mine (x int)', '42501', NULL, 'makes no table');
SELECT throws_ok('SELECT shop.ensure_month(''parts'')', '42501', NULL, 'calls no other function');
SELECT throws_ok('SELECT shop.follow(''parts'', ''id'', true)', '42501', NULL, 'nor this one');
RESET SESSION AUTHORIZATION;

SET SESSION AUTHORIZATION stranger;
SELECT throws_ok($$SELECT shop.ingest('11111111-1111-4111-8111-111111111111', '22222222-2222-4222-8222-222222222222', 0, '{}')$$,
    '42501', NULL, 'a stranger pushes nothing');
RESET SESSION AUTHORIZATION;

SET SESSION AUTHORIZATION reader_all;
SELECT is((SELECT count(*)::int FROM shop.stores), (SELECT n FROM all_stores) + 1, 'a reader without a list sees every store');
SELECT lives_ok('SELECT * FROM shop.all_parts; SELECT * FROM shop.verdicts; SELECT * FROM shop.capability; SELECT * FROM shop.tool_life;
    SELECT * FROM shop.alarm_history; SELECT * FROM shop.stops; SELECT * FROM shop.feeds; SELECT * FROM shop.measurements_that_hold',
    'and every view');
SELECT throws_ok('DELETE FROM shop.parts', '42501', NULL, 'a reader deletes nothing');
SELECT throws_ok('UPDATE shop.measurements SET diameter_mm = 1', '42501', NULL, 'changes nothing');
SELECT throws_ok($$SELECT shop.ingest('11111111-1111-4111-8111-111111111111', '22222222-2222-4222-8222-222222222222', 0, '{}')$$,
    '42501', NULL, 'pushes nothing');
RESET SESSION AUTHORIZATION;

SET SESSION AUTHORIZATION reader_one;
SELECT is((SELECT count(DISTINCT store)::int FROM shop.stores), 1, 'a reader with a list sees the stores on it');
SELECT is((SELECT count(DISTINCT store)::int FROM shop.parts), 1, 'also through the tables');
RESET SESSION AUTHORIZATION;

SELECT * FROM finish();
ROLLBACK;
