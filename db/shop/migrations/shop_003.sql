-- 003: where each measured value came from: keypad, which gauge, which file.

-- statement: sources of measurements; those accepted before have none
CREATE TABLE shop.measurement_sources (
    store uuid NOT NULL, epoch uuid NOT NULL, measurement_id bigint NOT NULL, seq bigint NOT NULL, received timestamptz NOT NULL,
    source text, name text,
    PRIMARY KEY (store, epoch, measurement_id, received)
) PARTITION BY RANGE (received);

-- statement: consoles may fill it
SELECT shop.follow('measurement_sources', 'measurement_id', false);

-- statement: its partition of this month
SELECT shop.ensure_month('measurement_sources');

-- statement: readers see the rows of their stores
ALTER TABLE shop.measurement_sources ENABLE ROW LEVEL SECURITY;

-- statement: as in every table that has a store
CREATE POLICY readers ON shop.measurement_sources FOR SELECT TO kerf_reader USING (store IN (SELECT shop.readable_stores()));

-- statement: and may read it
GRANT SELECT ON shop.measurement_sources TO kerf_reader;

-- statement: the source beside each value that holds; new columns at the end
CREATE OR REPLACE VIEW shop.measurements_that_hold WITH (security_invoker = true) AS
SELECT m.store, m.epoch, m.id AS measurement_id, m.part_id, m.station, m.position_mm, m.diameter_mm,
       coalesce(s.source, m.source) AS source, m.author,
       to_timestamp(m.accepted_utc_ms / 1000.0) AS accepted, m.kind = 'correction' AS corrected, s.name AS source_name
  FROM shop.measurements m
  LEFT JOIN shop.measurement_sources s ON s.store = m.store AND s.epoch = m.epoch AND s.measurement_id = m.id
 WHERE m.kind <> 'void'
   AND NOT EXISTS (SELECT 1 FROM shop.measurements n WHERE n.store = m.store AND n.epoch = m.epoch AND n.replaces_id = m.id
                                                       AND n.part_id = m.part_id);
