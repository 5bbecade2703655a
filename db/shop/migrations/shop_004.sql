-- 004: lots of every process: tool, gauge, people; which revision of its recipe a part was cut with, and its seal.

-- statement: tool or insert, gauge, who opened and closed it
ALTER TABLE shop.lots ADD COLUMN tool text, ADD COLUMN gauge text, ADD COLUMN opened_by text, ADD COLUMN closed_by text;

-- statement: the recipe's revision and the part's seal
ALTER TABLE shop.parts ADD COLUMN recipe_revision_id bigint, ADD COLUMN seal text;

-- statement: consoles may fill the new columns
SELECT shop.follow(name::name, 'id', true) FROM (VALUES ('lots'), ('parts')) AS f (name);
