-- 003: people known at the machine, in a table of their own; before, they were one line of text among the settings.

-- statement: accounts; the seal is a password hash (argon2id), never the PIN itself, and stands nowhere else
CREATE TABLE accounts (
    name           TEXT PRIMARY KEY CHECK (name <> ''),
    role           TEXT NOT NULL CHECK (role IN ('operator', 'setter', 'engineer')),
    seal           TEXT NOT NULL DEFAULT '',
    wrong_tries    INTEGER NOT NULL DEFAULT 0 CHECK (wrong_tries >= 0),
    last_wrong_utc_ms INTEGER NOT NULL DEFAULT 0,
    changed_utc_ms INTEGER NOT NULL
) STRICT, WITHOUT ROWID;
