// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "db/row_io.h"
#include "db/stores/audit_log.h"
#include "db/stores/store.h"

/// Machines, part types with their recipes, lots.
namespace kerf::db {
namespace {

struct SavedRecipe {
    RecipeRevisionId id;
    std::uint32_t revision;
};

/// Where the limits of figures stand in the parameters of a recipe, whatever else these are.
constexpr const char* kLimitsPath = "$.figure_limits";

/// Limits of figures stay with the part type when something else of its recipe changes: those of the revision that
/// comes back, else of the newest one. What says its own keeps them; what says nothing else leaves the rest as it is.
std::string withLimits(const QSqlDatabase& database, const SaveRecipe& recipe) {
    Statement carry(database,
                    "SELECT json_set(g.given, g.path, json(json_extract(r.parameters, g.path))) FROM (SELECT ? AS "
                    "given, ? AS path, ? AS type, ? AS back) g JOIN recipe_revisions r ON r.part_type_id = g.type AND "
                    "r.revision = coalesce(g.back, (SELECT max(n.revision) FROM recipe_revisions n WHERE "
                    "n.part_type_id = g.type)) WHERE json_type(r.parameters, g.path) = 'object' AND "
                    "json_type(g.given) = 'object' AND json_type(g.given, g.path) IS NULL");
    carry.bind(recipe.parametersJson).bind(kLimitsPath).bind(recipe.partType).bind(recipe.restoredFrom);
    if (carry.run().next()) {
        return carry.text(0);
    }
    Statement alone(database,
                    "SELECT json_set(r.parameters, g.path, json(json_extract(g.given, g.path))) FROM (SELECT ? AS "
                    "given, ? AS path, ? AS type) g JOIN recipe_revisions r ON r.part_type_id = g.type AND r.revision "
                    "= (SELECT max(n.revision) FROM recipe_revisions n WHERE n.part_type_id = g.type) WHERE "
                    "json_type(g.given, g.path) = 'object' AND (SELECT count(*) FROM json_each(g.given)) = 1");
    alone.bind(recipe.parametersJson).bind(kLimitsPath).bind(recipe.partType);
    return alone.run().next() ? alone.text(0) : recipe.parametersJson;
}

/// `hashedAs`: of this part type the log notes a hash in the place of the parameters, which may be long (a tuning with
/// its curves).
SavedRecipe addRevision(const QSqlDatabase& database, const SaveRecipe& recipe, const std::string& hashedAs = {}) {
    const std::string parameters = withLimits(database, recipe);
    const std::string hashed = hashedAs.empty() ? std::string() : roomRecordText(hashedAs, parameters);
    Statement newest(
        database,
        "SELECT revision, parameters FROM recipe_revisions WHERE part_type_id = ? ORDER BY revision DESC LIMIT 1");
    const bool first = !newest.bind(recipe.partType).run().next();
    const std::uint32_t revision = first ? 1 : newest.count(0) + 1;
    const std::string before = first ? std::string() : newest.text(1);
    Statement insert(database,
                     "INSERT INTO recipe_revisions (part_type_id, revision, parameters, restored_from, author, reason, "
                     "created_utc_ms) VALUES (?, ?, ?, ?, ?, ?, ?)");
    insert.bind(recipe.partType)
        .bind(revision)
        .bind(parameters)
        .bind(recipe.restoredFrom)
        .bind(recipe.author)
        .bind(recipe.reason)
        .bind(utcNow_ms())
        .run();
    appendAudit(database, {.author = recipe.author,
                           .action = recipe.restoredFrom ? "recipe rolled back" : "recipe saved",
                           .object = "part_type",
                           .objectId = recipe.partType,
                           .oldValue = hashed.empty() ? before : std::string(),
                           .newValue = hashed.empty() ? parameters : hashed,
                           .reason = recipe.reason});
    return {insert.lastId(), revision};
}

}  // namespace

Receipt Store::run(const EnsureMachine& command) {
    Statement find(m_database, "SELECT id FROM machines WHERE name = ?");
    if (find.bind(command.name).run().next()) {
        return {find.integer(0)};
    }
    Statement insert(m_database, "INSERT INTO machines (name, kind, created_utc_ms) VALUES (?, ?, ?)");
    return {insert.bind(command.name).bind(command.kind).bind(utcNow_ms()).run().lastId()};
}

Receipt Store::run(const EnsurePartType& command) {
    Statement find(m_database,
                   "SELECT t.id, max(r.id) FROM part_types t JOIN recipe_revisions r ON r.part_type_id = t.id "
                   "WHERE t.process = ? AND t.name = ? GROUP BY t.id");
    if (find.bind(processKey(command.process)).bind(command.name).run().next()) {
        return {find.integer(0), find.integer(1)};
    }
    Statement insert(m_database, "INSERT INTO part_types (process, name, created_utc_ms) VALUES (?, ?, ?)");
    const PartTypeId id = insert.bind(processKey(command.process)).bind(command.name).bind(utcNow_ms()).run().lastId();
    return {id, addRevision(m_database, {id, command.parametersJson, command.author, "part type created", {}}).id};
}

Receipt Store::run(const SaveRecipe& command) {
    const SavedRecipe saved = addRevision(m_database, command);
    return {saved.id, saved.revision};
}

Receipt Store::run(const RestoreRecipe& command) {
    Statement find(m_database, "SELECT parameters FROM recipe_revisions WHERE part_type_id = ? AND revision = ?");
    if (!find.bind(command.partType).bind(command.revision).run().next()) {
        throw SqlFailure(Sentence(KERF_TEXT("The recipe has no revision %1."), SentenceArg(command.revision, 0)), 0,
                         "no such recipe revision");
    }
    const SavedRecipe saved =
        addRevision(m_database, {command.partType, find.text(0), command.author, command.reason, command.revision});
    return {saved.id, saved.revision};
}

Receipt Store::run(const KeepRecipe& command) {
    Statement find(m_database, "SELECT id FROM part_types WHERE process = ? AND name = ?");
    const bool known = find.bind(processKey(command.process)).bind(command.partType).run().next();
    PartTypeId id = known ? find.integer(0) : 0;
    if (!known) {
        Statement insert(m_database, "INSERT INTO part_types (process, name, created_utc_ms) VALUES (?, ?, ?)");
        id = insert.bind(processKey(command.process)).bind(command.partType).bind(utcNow_ms()).run().lastId();
    }
    const SavedRecipe saved =
        addRevision(m_database, {id, command.parametersJson, command.author, command.reason, command.restoredFrom},
                    command.partType);
    return {saved.id, saved.revision};
}

Receipt Store::run(const EnsureLot& command) {
    Statement find(m_database, "SELECT id FROM lots WHERE machine_id = ? AND part_type_id = ? AND name = ?");
    if (find.bind(command.machine).bind(command.partType).bind(command.name).run().next()) {
        return {find.integer(0)};
    }
    Statement insert(m_database,
                     "INSERT INTO lots (machine_id, part_type_id, recipe_revision_id, name, size, estimator, "
                     "opened_utc_ms, tool, gauge, opened_by) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    LotRow lot;
    lot.machine = command.machine;
    lot.partType = command.partType;
    lot.recipe = command.recipe;
    lot.name = command.name;
    lot.size = command.size;
    lot.estimator = command.estimator;
    lot.openedUtc_ms = utcNow_ms();
    lot.tool = command.tool;
    lot.gauge = command.gauge;
    insert.bind(lot.machine)
        .bind(lot.partType)
        .bind(lot.recipe)
        .bind(lot.name)
        .bind(lot.size)
        .bind(lot.estimator)
        .bind(lot.openedUtc_ms)
        .bind(lot.tool)
        .bind(lot.gauge)
        .bind(command.author)
        .run();
    lot.id = insert.lastId();
    appendAudit(m_database, {.author = command.author,
                             .action = kLotOpened,
                             .object = "lot",
                             .objectId = lot.id,
                             .newValue = lotText(lot)});
    return {lot.id};
}

Receipt Store::run(const CloseLot& command) {
    const std::int64_t now_ms = utcNow_ms();
    Statement close(m_database,
                    "UPDATE lots SET closed_utc_ms = ?, closed_by = ? WHERE id = ? AND closed_utc_ms IS NULL");
    if (close.bind(now_ms).bind(command.author).bind(command.lot).run().changed() == 0) {
        throw SqlFailure(Sentence(KERF_TEXT("This lot is closed already, or there is none of that number.")), 0,
                         "lot not open");
    }
    appendAudit(m_database, {.author = command.author,
                             .action = kLotClosed,
                             .object = "lot",
                             .objectId = command.lot,
                             .newValue = lotEndText(now_ms),
                             .reason = command.reason});
    return {command.lot};
}

Receipt Store::run(const SetActiveLot& command) {
    return run(ChangeSetting{activeLotKey(command.process), command.lot ? std::to_string(*command.lot) : std::string(),
                             command.author, "lot selected"});
}

}  // namespace kerf::db
