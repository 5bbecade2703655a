-- 001: the shop's schema. Never edited after release; a change is a new numbered file, and the schema only grows.
--
-- Each block after a "-- statement:" line is exactly one SQL statement (db/migrator.h). Tables bear the console's names and
-- columns, with store, epoch and the outbox number in front. No CHECK and no foreign key is repeated here: what a console
-- has accepted is not refused a second time.

-- statement: which step was applied when, by which version of the program
CREATE TABLE shop.schema_steps (
    version int PRIMARY KEY,
    applied timestamptz NOT NULL DEFAULT now(),
    program text NOT NULL
);

-- statement: the server's own choices
CREATE TABLE shop.server_settings (
    key   text PRIMARY KEY,
    value text NOT NULL
);

-- statement: a console must be enrolled, unless this server is for tests
INSERT INTO shop.server_settings VALUES ('allow_unenrolled', 'false');

-- statement: which role speaks for which console
CREATE TABLE shop.enrolled (
    store    uuid PRIMARY KEY,
    role     name NOT NULL,
    console  text NOT NULL,
    enrolled timestamptz NOT NULL DEFAULT now()
);

-- statement: one row per history that was ever pushed; a restored backup or a cloned folder has one of its own
CREATE TABLE shop.stores (
    store           uuid NOT NULL,
    epoch           uuid NOT NULL,
    reason          text NOT NULL,
    began_utc_ms    bigint NOT NULL,
    program         text NOT NULL,
    first_contact   timestamptz NOT NULL DEFAULT now(),
    last_contact    timestamptz NOT NULL DEFAULT now(),
    clock_offset_ms bigint NOT NULL,
    PRIMARY KEY (store, epoch)
);

-- statement: how far each stream of a history has come
CREATE TABLE shop.streams (
    store         uuid NOT NULL,
    epoch         uuid NOT NULL,
    stream        text NOT NULL CHECK (stream IN ('rows', 'traces')),
    last_seq      bigint NOT NULL DEFAULT 0,
    last_mark     bigint,
    audit_head    text,
    last_received timestamptz,
    PRIMARY KEY (store, epoch, stream),
    FOREIGN KEY (store, epoch) REFERENCES shop.stores (store, epoch)
);

-- statement: rows that could not be taken, with the reason; the text is the row as it came
CREATE TABLE shop.quarantine (
    store      uuid NOT NULL,
    epoch      uuid NOT NULL,
    stream     text NOT NULL,
    seq        bigint NOT NULL,
    table_name text NOT NULL,
    row_key    text NOT NULL,
    reason     text NOT NULL,
    row        text NOT NULL,
    received   timestamptz NOT NULL DEFAULT now(),
    PRIMARY KEY (store, epoch, stream, seq)
);

-- statement: machines
CREATE TABLE shop.machines (
    store uuid NOT NULL, epoch uuid NOT NULL, id bigint NOT NULL, seq bigint NOT NULL, received timestamptz NOT NULL,
    name text, kind text, created_utc_ms bigint,
    PRIMARY KEY (store, epoch, id)
);

-- statement: part types
CREATE TABLE shop.part_types (
    store uuid NOT NULL, epoch uuid NOT NULL, id bigint NOT NULL, seq bigint NOT NULL, received timestamptz NOT NULL,
    process text, name text, created_utc_ms bigint,
    PRIMARY KEY (store, epoch, id)
);

-- statement: recipe revisions
CREATE TABLE shop.recipe_revisions (
    store uuid NOT NULL, epoch uuid NOT NULL, id bigint NOT NULL, seq bigint NOT NULL, received timestamptz NOT NULL,
    part_type_id bigint, revision bigint, parameters text, restored_from bigint, author text, reason text,
    created_utc_ms bigint,
    PRIMARY KEY (store, epoch, id)
);

-- statement: lots
CREATE TABLE shop.lots (
    store uuid NOT NULL, epoch uuid NOT NULL, id bigint NOT NULL, seq bigint NOT NULL, received timestamptz NOT NULL,
    machine_id bigint, part_type_id bigint, recipe_revision_id bigint, name text, size bigint, estimator text,
    opened_utc_ms bigint, closed_utc_ms bigint,
    PRIMARY KEY (store, epoch, id)
);

-- statement: boring schedules
CREATE TABLE shop.schedules (
    store uuid NOT NULL, epoch uuid NOT NULL, id bigint NOT NULL, seq bigint NOT NULL, received timestamptz NOT NULL,
    lot_id bigint, revision bigint, ln_c float8, alpha float8, beta float8, target_deflection_mm float8,
    constant_feed_mm_per_rev float8, min_feed_mm_per_rev float8, max_feed_mm_per_rev float8, overhang_from_mm float8,
    overhang_to_mm float8, spindle_speed_rpm float8, prediction text, reason text, created_utc_ms bigint,
    accepted_by text, accepted_utc_ms bigint, teach_feed_mm_per_rev float8, teach_from_mm float8,
    PRIMARY KEY (store, epoch, id)
);

-- statement: parts, a partition per month of receipt
CREATE TABLE shop.parts (
    store uuid NOT NULL, epoch uuid NOT NULL, id bigint NOT NULL, seq bigint NOT NULL, received timestamptz NOT NULL,
    process text, lot_id bigint, number bigint, serial text, complete bigint, machine_begin_ns bigint,
    machine_end_ns bigint, ended_utc_ms bigint, schedule_id bigint,
    PRIMARY KEY (store, epoch, id, received)
) PARTITION BY RANGE (received);

-- statement: figures of parts
CREATE TABLE shop.part_results (
    store uuid NOT NULL, epoch uuid NOT NULL, part_id bigint NOT NULL, seq bigint NOT NULL, received timestamptz NOT NULL,
    results text,
    PRIMARY KEY (store, epoch, part_id, received)
) PARTITION BY RANGE (received);

-- statement: the really cut feed
CREATE TABLE shop.feed_traces (
    store uuid NOT NULL, epoch uuid NOT NULL, part_id bigint NOT NULL, seq bigint NOT NULL, received timestamptz NOT NULL,
    points bytea,
    PRIMARY KEY (store, epoch, part_id, received)
) PARTITION BY RANGE (received);

-- statement: measurements
CREATE TABLE shop.measurements (
    store uuid NOT NULL, epoch uuid NOT NULL, id bigint NOT NULL, seq bigint NOT NULL, received timestamptz NOT NULL,
    part_id bigint, kind text, replaces_id bigint, station bigint, position_mm float8, diameter_mm float8, source text,
    confirmed bigint, author text, reason text, accepted_utc_ms bigint,
    PRIMARY KEY (store, epoch, id, received)
) PARTITION BY RANGE (received);

-- statement: estimator states
CREATE TABLE shop.estimator_states (
    store uuid NOT NULL, epoch uuid NOT NULL, id bigint NOT NULL, seq bigint NOT NULL, received timestamptz NOT NULL,
    lot_id bigint, measurement_id bigint, cause_measurement_id bigint, estimator text, ln_c float8, alpha float8,
    beta float8, p00 float8, p01 float8, p02 float8, p11 float8, p12 float8, p22 float8, perturbed bigint, state text,
    PRIMARY KEY (store, epoch, id, received)
) PARTITION BY RANGE (received);

-- statement: audit log
CREATE TABLE shop.audit (
    store uuid NOT NULL, epoch uuid NOT NULL, id bigint NOT NULL, seq bigint NOT NULL, received timestamptz NOT NULL,
    utc_ms bigint, author text, action text, object text, object_id bigint, old_value text, new_value text, reason text,
    previous_hash text, hash text,
    PRIMARY KEY (store, epoch, id, received)
) PARTITION BY RANGE (received);

-- statement: alarms
CREATE TABLE shop.alarms (
    store uuid NOT NULL, epoch uuid NOT NULL, id bigint NOT NULL, seq bigint NOT NULL, received timestamptz NOT NULL,
    code bigint, priority bigint, raised_utc_ms bigint, cleared_utc_ms bigint, clear_cause text,
    acknowledged_utc_ms bigint, acknowledged_by text, detail_text text, detail_args text,
    PRIMARY KEY (store, epoch, id)
);

-- statement: settings, the newest value
CREATE TABLE shop.settings (
    store uuid NOT NULL, epoch uuid NOT NULL, key text NOT NULL, seq bigint NOT NULL, received timestamptz NOT NULL,
    value text, changed_by text, changed_utc_ms bigint,
    PRIMARY KEY (store, epoch, key)
);

-- statement: what rooms keep
CREATE TABLE shop.room_records (
    store uuid NOT NULL, epoch uuid NOT NULL, id bigint NOT NULL, seq bigint NOT NULL, received timestamptz NOT NULL,
    process text, kind text, subject text, body text, author text, reason text, created_utc_ms bigint,
    PRIMARY KEY (store, epoch, id)
);

-- statement: measurements of one part
CREATE INDEX measurements_by_part ON shop.measurements (store, epoch, part_id);

-- statement: parts by time of receipt; rows arrive in order of time, so a few pages of index do for years
CREATE INDEX parts_by_time ON shop.parts USING brin (received);

-- statement: measurements by time of receipt
CREATE INDEX measurements_by_time ON shop.measurements USING brin (received);

-- statement: tables a console may fill, and the statements that do it
CREATE TABLE shop.tables (
    name        name PRIMARY KEY,
    row_key     name NOT NULL,
    updatable   boolean NOT NULL,
    partitioned boolean NOT NULL,
    update_sql  text,
    insert_sql  text NOT NULL
);

-- statement: takes a table among those that a console may fill; to be called again when it has got a new column
CREATE FUNCTION shop.follow(table_name name, key name, changes boolean) RETURNS void LANGUAGE plpgsql AS $follow$
DECLARE
    own         text;
    from_rows   text;
    assignments text;
    split       boolean;
BEGIN
    SELECT string_agg(quote_ident(attname), ', ' ORDER BY attnum), string_agg('r.' || quote_ident(attname), ', ' ORDER BY attnum),
           string_agg(quote_ident(attname) || ' = r.' || quote_ident(attname), ', ' ORDER BY attnum)
      INTO own, from_rows, assignments
      FROM pg_catalog.pg_attribute
     WHERE attrelid = format('shop.%I', table_name)::regclass AND attnum > 0 AND NOT attisdropped
       AND attname NOT IN ('store', 'epoch', 'seq', 'received', key);
    SELECT relkind = 'p' INTO split FROM pg_catalog.pg_class WHERE oid = format('shop.%I', table_name)::regclass;
    INSERT INTO shop.tables VALUES (table_name, key, changes, split,
        CASE WHEN changes THEN format(
            'UPDATE shop.%1$I t SET seq = r.seq, %2$s FROM json_populate_recordset(NULL::shop.%1$I, $3) r '
            'WHERE t.store = $1 AND t.epoch = $2 AND t.%3$I = r.%3$I', table_name, assignments, key) END,
        format('INSERT INTO shop.%1$I (store, epoch, %2$I, seq, received, %3$s) SELECT $1, $2, r.%2$I, r.seq, now(), %4$s '
               'FROM json_populate_recordset(NULL::shop.%1$I, $3) r', table_name, key, own, from_rows)
        || CASE WHEN changes THEN format(' WHERE NOT EXISTS (SELECT 1 FROM shop.%1$I t WHERE t.store = $1 AND t.epoch = $2 '
                                         'AND t.%2$I = r.%2$I)', table_name, key) ELSE '' END)
    ON CONFLICT (name) DO UPDATE SET row_key = excluded.row_key, updatable = excluded.updatable,
        update_sql = excluded.update_sql, insert_sql = excluded.insert_sql;
END
$follow$;

-- statement: the console's tables; true: a row may change after it was sent
SELECT shop.follow(name::name, key::name, changes) FROM (VALUES
    ('machines', 'id', true), ('part_types', 'id', true), ('recipe_revisions', 'id', false), ('lots', 'id', true),
    ('schedules', 'id', true), ('parts', 'id', true), ('part_results', 'part_id', false),
    ('feed_traces', 'part_id', false), ('measurements', 'id', false), ('estimator_states', 'id', false),
    ('alarms', 'id', true), ('settings', 'key', true), ('audit', 'id', false), ('room_records', 'id', false)
) AS f (name, key, changes);

-- statement: the partition of this month, made by whoever comes first
CREATE FUNCTION shop.ensure_month(table_name name) RETURNS void LANGUAGE plpgsql AS $month$
DECLARE
    month  timestamptz := date_trunc('month', now(), 'UTC');
    child  text := table_name || to_char(month AT TIME ZONE 'UTC', '_YYYYMM');
BEGIN
    IF to_regclass(format('shop.%I', child)) IS NULL THEN
        PERFORM pg_advisory_xact_lock(hashtext('shop.' || child));
        EXECUTE format('CREATE TABLE IF NOT EXISTS shop.%I PARTITION OF shop.%I FOR VALUES FROM (%L) TO (%L)', child, table_name,
                       month, date_trunc('month', month + interval '40 days', 'UTC'));
    END IF;
END
$month$;

-- statement: the partitions of this month
SELECT shop.ensure_month(name) FROM shop.tables WHERE partitioned;

-- statement: may whoever is connected push for this store? An owner of the schema may; an enrolled role for its own
CREATE FUNCTION shop.may_push(this_store uuid) RETURNS boolean LANGUAGE sql STABLE AS $may$
    SELECT pg_has_role(session_user, (SELECT nspowner FROM pg_namespace WHERE nspname = 'shop'), 'member')
        OR EXISTS (SELECT 1 FROM shop.enrolled WHERE store = this_store AND role = session_user)
        OR (NOT EXISTS (SELECT 1 FROM shop.enrolled WHERE store = this_store OR role = session_user)
            AND EXISTS (SELECT 1 FROM shop.server_settings WHERE key = 'allow_unenrolled' AND value = 'true'))
$may$;

-- statement: how far this history has come, as a console is told
CREATE FUNCTION shop.state(this_store uuid, this_epoch uuid, status text) RETURNS json LANGUAGE sql STABLE AS $state$
    SELECT json_build_object('status', status, 'utc_ms', (extract(epoch FROM clock_timestamp()) * 1000)::bigint,
        'streams', (SELECT json_object_agg(stream, json_build_object('last_seq', last_seq, 'last_mark', last_mark,
                                                                     'audit_head', audit_head))
                      FROM shop.streams WHERE store = this_store AND epoch = this_epoch))
$state$;

-- statement: the one function a console may call
-- batch {"hello": {reason, began_utc_ms, program, utc_ms}} with first_seq 0 introduces the console; the answer says how far its
-- history has come and which columns are known. Otherwise
--   {"stream": "rows"|"traces", "previous_mark": mark of first_seq - 1, "marks": [one per number from first_seq],
--    "tables": {name: [{"seq": n, column: value, …}]}, "aside": [{"seq", "table", "key", "reason", "row"}]}
-- What was taken before is skipped, so a lost answer does no harm. Two histories with the same identity are told apart by
-- their marks and refused ("diverged"); a batch wholly behind or beyond is "behind" or "gap": introduce yourself again.
CREATE FUNCTION shop.ingest(store uuid, epoch uuid, first_seq bigint, batch json) RETURNS json
LANGUAGE plpgsql SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $ingest$
DECLARE
    this_store uuid := $1;
    this_epoch uuid := $2;
    from_seq   bigint := $3;
    body       json := $4;
    hello      json := body -> 'hello';
    this_stream text := body ->> 'stream';
    at         record;
    to_seq     bigint;
    mark       bigint;
    part       record;
    known      record;
    fresh      json;
    head       text;
BEGIN
    IF this_store IS NULL OR this_epoch IS NULL OR from_seq IS NULL OR body IS NULL OR NOT shop.may_push(this_store) THEN
        RAISE insufficient_privilege USING MESSAGE = 'this console is not enrolled here';
    END IF;
    IF hello IS NOT NULL THEN
        INSERT INTO shop.stores AS s (store, epoch, reason, began_utc_ms, program, clock_offset_ms)
        VALUES (this_store, this_epoch, hello ->> 'reason', (hello ->> 'began_utc_ms')::bigint, hello ->> 'program',
                (hello ->> 'utc_ms')::bigint - (extract(epoch FROM clock_timestamp()) * 1000)::bigint)
        ON CONFLICT ON CONSTRAINT stores_pkey DO UPDATE
           SET last_contact = now(), program = excluded.program, clock_offset_ms = excluded.clock_offset_ms;
        INSERT INTO shop.streams (store, epoch, stream) VALUES (this_store, this_epoch, 'rows'), (this_store, this_epoch, 'traces')
        ON CONFLICT DO NOTHING;
        RETURN (SELECT json_build_object('status', s ->> 'status', 'utc_ms', s -> 'utc_ms', 'streams', s -> 'streams', 'tables',
                   (SELECT json_object_agg(t.name, (SELECT json_agg(attname) FROM pg_attribute WHERE attrelid =
                        format('shop.%I', t.name)::regclass AND attnum > 0 AND NOT attisdropped)) FROM shop.tables t))
                  FROM shop.state(this_store, this_epoch, 'ok') s);
    END IF;
    PERFORM 1 FROM shop.stores s WHERE s.store = this_store AND s.epoch = this_epoch FOR UPDATE;
    SELECT st.last_seq, st.last_mark INTO at FROM shop.streams st
     WHERE st.store = this_store AND st.epoch = this_epoch AND st.stream = this_stream;
    to_seq := from_seq + json_array_length(body -> 'marks') - 1;
    IF at IS NULL OR from_seq > at.last_seq + 1 THEN
        RETURN shop.state(this_store, this_epoch, 'gap');
    ELSIF to_seq < at.last_seq THEN
        RETURN shop.state(this_store, this_epoch, 'behind');
    END IF;
    IF at.last_seq > 0 THEN
        mark := CASE WHEN from_seq = at.last_seq + 1 THEN (body ->> 'previous_mark')::bigint
                     ELSE (body -> 'marks' ->> (at.last_seq - from_seq)::int)::bigint END;
        IF mark IS DISTINCT FROM at.last_mark THEN
            RETURN shop.state(this_store, this_epoch, 'diverged');
        END IF;
    END IF;
    IF to_seq <= at.last_seq THEN
        RETURN shop.state(this_store, this_epoch, 'ok');
    END IF;
    FOR part IN SELECT e.key AS name, e.value AS rows FROM json_each(body -> 'tables') e LOOP
        SELECT * INTO known FROM shop.tables t WHERE t.name = part.name::name;
        IF known IS NULL THEN
            RAISE undefined_table USING MESSAGE = format('the shop has no table %s', part.name);
        END IF;
        fresh := CASE WHEN from_seq > at.last_seq THEN part.rows
                      ELSE (SELECT coalesce(json_agg(r), '[]') FROM json_array_elements(part.rows) r
                             WHERE (r ->> 'seq')::bigint > at.last_seq) END;
        IF known.partitioned THEN
            PERFORM shop.ensure_month(known.name);
        END IF;
        IF known.updatable THEN
            EXECUTE known.update_sql USING this_store, this_epoch, fresh;
        END IF;
        EXECUTE known.insert_sql USING this_store, this_epoch, fresh;
        IF known.name = 'audit' THEN
            SELECT r ->> 'hash' INTO head FROM json_array_elements(fresh) r ORDER BY (r ->> 'seq')::bigint DESC LIMIT 1;
        END IF;
    END LOOP;
    INSERT INTO shop.quarantine (store, epoch, stream, seq, table_name, row_key, reason, row)
    SELECT this_store, this_epoch, this_stream, (a ->> 'seq')::bigint, a ->> 'table', a ->> 'key', a ->> 'reason', a ->> 'row'
      FROM json_array_elements(coalesce(body -> 'aside', '[]')) a WHERE (a ->> 'seq')::bigint > at.last_seq;
    UPDATE shop.streams st
       SET last_seq = to_seq, last_mark = (body -> 'marks' ->> (to_seq - from_seq)::int)::bigint,
           audit_head = coalesce(head, st.audit_head), last_received = now()
     WHERE st.store = this_store AND st.epoch = this_epoch AND st.stream = this_stream;
    UPDATE shop.stores s SET last_contact = now() WHERE s.store = this_store AND s.epoch = this_epoch;
    RETURN shop.state(this_store, this_epoch, 'ok');
END
$ingest$;
