-- 002: rights, and views for people.

-- statement: nobody but the owner, unless named below
REVOKE ALL ON SCHEMA shop FROM PUBLIC;

-- statement: functions are executable by everybody when made; these are not
REVOKE ALL ON ALL FUNCTIONS IN SCHEMA shop FROM PUBLIC;

-- statement: the roles belong to the whole server and may be there already
DO $roles$
BEGIN
    IF NOT EXISTS (SELECT 1 FROM pg_roles WHERE rolname = 'kerf_console') THEN
        CREATE ROLE kerf_console NOLOGIN;
    END IF;
    IF NOT EXISTS (SELECT 1 FROM pg_roles WHERE rolname = 'kerf_reader') THEN
        CREATE ROLE kerf_reader NOLOGIN;
    END IF;
END
$roles$;

-- statement: both find the schema
GRANT USAGE ON SCHEMA shop TO kerf_console, kerf_reader;

-- statement: all that a console may do
GRANT EXECUTE ON FUNCTION shop.ingest(uuid, uuid, bigint, json) TO kerf_console;

-- statement: which stores a reader may see; a reader without a row here sees all
CREATE TABLE shop.reader_stores (
    role  name NOT NULL,
    store uuid NOT NULL,
    PRIMARY KEY (role, store)
);

-- statement: the stores of whoever asks
CREATE FUNCTION shop.readable_stores() RETURNS SETOF uuid LANGUAGE sql STABLE SECURITY DEFINER
SET search_path = pg_catalog, pg_temp AS $readable$
    SELECT DISTINCT s.store FROM shop.stores s
     WHERE NOT EXISTS (SELECT 1 FROM shop.reader_stores r WHERE r.role = session_user)
        OR EXISTS (SELECT 1 FROM shop.reader_stores r WHERE r.role = session_user AND r.store = s.store)
$readable$;

-- statement: not for everybody
REVOKE ALL ON FUNCTION shop.readable_stores() FROM PUBLIC;

-- statement: row security asks it
GRANT EXECUTE ON FUNCTION shop.readable_stores() TO kerf_reader;

-- statement: readers see the rows of their stores in every table that has a store
DO $secure$
DECLARE
    one name;
BEGIN
    FOR one IN SELECT name FROM shop.tables UNION ALL VALUES ('stores'::name), ('streams'), ('quarantine') LOOP
        EXECUTE format('ALTER TABLE shop.%I ENABLE ROW LEVEL SECURITY', one);
        EXECUTE format('CREATE POLICY readers ON shop.%I FOR SELECT TO kerf_reader USING (store IN (SELECT shop.readable_stores()))',
                       one);
        EXECUTE format('GRANT SELECT ON shop.%I TO kerf_reader', one);
    END LOOP;
END
$secure$;

-- statement: how far each history has come; the newest of a store is the one that came to this server last
CREATE VIEW shop.consoles WITH (security_invoker = true) AS
SELECT s.store, s.epoch, s.reason, s.began_utc_ms, s.program, s.last_contact, s.clock_offset_ms,
       (SELECT m.name FROM shop.machines m WHERE m.store = s.store AND m.epoch = s.epoch ORDER BY m.id DESC LIMIT 1) AS machine,
       r.last_seq, r.audit_head, r.last_received, t.last_seq AS last_trace_seq,
       (SELECT count(*) FROM shop.quarantine q WHERE q.store = s.store AND q.epoch = s.epoch) AS quarantined,
       row_number() OVER (PARTITION BY s.store ORDER BY s.first_contact DESC) = 1 AS newest
  FROM shop.stores s
  JOIN shop.streams r ON r.store = s.store AND r.epoch = s.epoch AND r.stream = 'rows'
  JOIN shop.streams t ON t.store = s.store AND t.epoch = s.epoch AND t.stream = 'traces';

-- statement: parts with machine, lot and part type in words
CREATE VIEW shop.all_parts WITH (security_invoker = true) AS
SELECT p.store, p.epoch, p.id AS part_id, p.process, m.name AS machine, pt.name AS part_type, l.name AS lot, p.number,
       p.serial, p.complete = 1 AS complete, to_timestamp(p.ended_utc_ms / 1000.0) AS ended,
       (p.machine_end_ns - p.machine_begin_ns) / 1e9 AS cutting_time_s, p.received, p.lot_id, p.schedule_id,
       l.recipe_revision_id
  FROM shop.parts p
  LEFT JOIN shop.lots l ON l.store = p.store AND l.epoch = p.epoch AND l.id = p.lot_id
  LEFT JOIN shop.machines m ON m.store = p.store AND m.epoch = p.epoch AND m.id = l.machine_id
  LEFT JOIN shop.part_types pt ON pt.store = p.store AND pt.epoch = p.epoch AND pt.id = l.part_type_id;

-- statement: measurements that hold: neither corrected nor voided since
CREATE VIEW shop.measurements_that_hold WITH (security_invoker = true) AS
SELECT m.store, m.epoch, m.id AS measurement_id, m.part_id, m.station, m.position_mm, m.diameter_mm, m.source, m.author,
       to_timestamp(m.accepted_utc_ms / 1000.0) AS accepted, m.kind = 'correction' AS corrected
  FROM shop.measurements m
 WHERE m.kind <> 'void'
   AND NOT EXISTS (SELECT 1 FROM shop.measurements n WHERE n.store = m.store AND n.epoch = m.epoch AND n.replaces_id = m.id
                                                       AND n.part_id = m.part_id);

-- statement: each measured diameter against its recipe
CREATE VIEW shop.verdicts WITH (security_invoker = true) AS
SELECT p.store, p.epoch, p.machine, p.part_type, p.lot, p.number, p.serial, m.station, m.position_mm, m.diameter_mm,
       t.lower_mm, t.upper_mm, p.ended, p.part_id, p.lot_id,
       CASE WHEN t.lower_mm IS NULL OR t.upper_mm IS NULL THEN NULL
            WHEN m.diameter_mm < t.lower_mm THEN 'below' WHEN m.diameter_mm > t.upper_mm THEN 'above' ELSE 'inside' END AS verdict
  FROM shop.measurements_that_hold m
  JOIN shop.all_parts p ON p.store = m.store AND p.epoch = m.epoch AND p.part_id = m.part_id
  LEFT JOIN shop.recipe_revisions r ON r.store = p.store AND r.epoch = p.epoch AND r.id = p.recipe_revision_id
  CROSS JOIN LATERAL (SELECT (r.parameters::json ->> 'boring.lower_tolerance_mm')::float8 AS lower_mm,
                             (r.parameters::json ->> 'boring.upper_tolerance_mm')::float8 AS upper_mm) t;

-- statement: the feed a part was bored with
CREATE VIEW shop.feeds WITH (security_invoker = true) AS
SELECT p.store, p.epoch, p.machine, p.part_type, p.lot, p.number, s.revision, s.ln_c, s.alpha, s.beta,
       s.target_deflection_mm, s.min_feed_mm_per_rev, s.max_feed_mm_per_rev, s.spindle_speed_rpm, p.ended
  FROM shop.all_parts p
  JOIN shop.schedules s ON s.store = p.store AND s.epoch = p.epoch AND s.id = p.schedule_id;

-- statement: spread of a lot against its tolerance, by depth; an overall figure, to be read with the course beside it
CREATE VIEW shop.capability WITH (security_invoker = true) AS
SELECT store, epoch, machine, part_type, lot, station, count(*) AS measured, avg(diameter_mm) AS mean_mm,
       stddev_samp(diameter_mm) AS sigma_mm, min(lower_mm) AS lower_mm, max(upper_mm) AS upper_mm,
       (max(upper_mm) - min(lower_mm)) / nullif(6 * stddev_samp(diameter_mm), 0) AS pp,
       least(max(upper_mm) - avg(diameter_mm), avg(diameter_mm) - min(lower_mm))
           / nullif(3 * stddev_samp(diameter_mm), 0) AS ppk,
       count(*) FILTER (WHERE verdict <> 'inside') AS outside
  FROM shop.verdicts
 GROUP BY store, epoch, machine, part_type, lot, station;

-- statement: parts and cutting time between the tool changes that the rooms have kept
CREATE VIEW shop.tool_life WITH (security_invoker = true) AS
WITH changes AS (
    SELECT store, epoch, process, kind, subject, created_utc_ms AS from_utc_ms,
           lead(created_utc_ms) OVER (PARTITION BY store, epoch, process ORDER BY id) AS to_utc_ms
      FROM shop.room_records WHERE kind ILIKE '%tool%' OR kind ILIKE '%insert%')
SELECT c.store, c.epoch, c.process, c.kind, c.subject, to_timestamp(c.from_utc_ms / 1000.0) AS from_time,
       to_timestamp(c.to_utc_ms / 1000.0) AS to_time, count(p.id) AS parts,
       coalesce(sum(p.machine_end_ns - p.machine_begin_ns), 0) / 1e9 AS cutting_time_s
  FROM changes c
  LEFT JOIN shop.parts p ON p.store = c.store AND p.epoch = c.epoch AND p.process = c.process
                        AND p.ended_utc_ms >= c.from_utc_ms AND (c.to_utc_ms IS NULL OR p.ended_utc_ms < c.to_utc_ms)
 GROUP BY c.store, c.epoch, c.process, c.kind, c.subject, c.from_utc_ms, c.to_utc_ms;

-- statement: alarms with their lengths
CREATE VIEW shop.alarm_history WITH (security_invoker = true) AS
SELECT a.store, a.epoch, a.id AS alarm_id, a.code, a.priority, to_timestamp(a.raised_utc_ms / 1000.0) AS raised,
       to_timestamp(a.cleared_utc_ms / 1000.0) AS cleared, (a.cleared_utc_ms - a.raised_utc_ms) / 1000.0 AS stood_s,
       a.clear_cause, nullif(a.acknowledged_by, '') AS acknowledged_by, a.detail_text, a.detail_args
  FROM shop.alarms a;

-- statement: pauses of more than five minutes between two parts of a machine
CREATE VIEW shop.stops WITH (security_invoker = true) AS
SELECT store, epoch, machine, before AS from_time, ended AS to_time, extract(epoch FROM ended - before) AS gap_s
  FROM (SELECT store, epoch, machine, ended, lag(ended) OVER (PARTITION BY store, epoch, machine ORDER BY part_id) AS before
          FROM shop.all_parts) g
 WHERE ended - before > interval '5 minutes';

-- statement: views are for readers
GRANT SELECT ON shop.consoles, shop.all_parts, shop.measurements_that_hold, shop.verdicts, shop.feeds, shop.capability,
    shop.tool_life, shop.alarm_history, shop.stops TO kerf_reader;
