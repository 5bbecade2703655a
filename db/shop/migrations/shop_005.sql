-- 005: since its version 8 a data file has no row of its own for a source that has no name: its name stays empty in the view.

-- statement: as in 003, an unknown name empty
CREATE OR REPLACE VIEW shop.measurements_that_hold WITH (security_invoker = true) AS
SELECT m.store, m.epoch, m.id AS measurement_id, m.part_id, m.station, m.position_mm, m.diameter_mm,
       coalesce(s.source, m.source) AS source, m.author,
       to_timestamp(m.accepted_utc_ms / 1000.0) AS accepted, m.kind = 'correction' AS corrected,
       coalesce(s.name, '') AS source_name
  FROM shop.measurements m
  LEFT JOIN shop.measurement_sources s ON s.store = m.store AND s.epoch = m.epoch AND s.measurement_id = m.id
 WHERE m.kind <> 'void'
   AND NOT EXISTS (SELECT 1 FROM shop.measurements n WHERE n.store = m.store AND n.epoch = m.epoch AND n.replaces_id = m.id
                                                       AND n.part_id = m.part_id);
