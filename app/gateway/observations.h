// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

namespace kerf::gateway {

enum class Category : std::uint8_t { Sample, Event, Condition };

/// One data item of the device, as /probe describes it.
struct DataItem {
    const char* id;
    Category category;
    const char* type;       ///< MTConnect vocabulary
    const char* subType;    ///< "": none
    const char* units;      ///< "": none
    const char* element;    ///< name of its observations in /current and /sample
    const char* component;  ///< id of the component it belongs to
    const char* representation{""};
};

/// The items of every machine, in the order of the document.
[[nodiscard]] const std::vector<DataItem>& dataItems();

/// A part of the device.
struct Component {
    const char* id;
    const char* element;  ///< "Linear"
    const char* name;
    const char* parent;  ///< id; "": the device
};
[[nodiscard]] const std::vector<Component>& components();

/// One entry of a set or a row of a table.
struct Entry {
    QString key{};
    QString text{};                                    ///< of a set
    std::vector<std::pair<QString, QString>> cells{};  ///< of a table
    bool operator==(const Entry&) const = default;
};

struct Condition {
    QString level{};  ///< Normal, Warning, Fault, Unavailable
    QString code{};
    QString text{};
    bool operator==(const Condition&) const = default;
};

/// What is known of a data item.
struct Value {
    bool available{false};
    QString text{};
    std::vector<Entry> entries{};         ///< of sets and tables
    std::vector<Condition> conditions{};  ///< of a condition: all that stand; none: normal
    bool operator==(const Value&) const = default;
    static Value of(const QString& text) { return {true, text, {}, {}}; }
};

struct Observation {
    quint64 sequence{0};
    qint64 utc_ms{0};
    const DataItem* item{nullptr};
    Value value{};
    Condition condition{};  ///< of a condition item: the one that changed
};

/// The newest value of every item, and the last changes in order. Memory is bounded by the capacity. Sequence numbers
/// begin with 1 and never have a gap.
class Observations {
 public:
    explicit Observations(std::size_t capacity = 131072);

    /// Takes over what has changed; a value that is the same makes no observation.
    void set(const char* id, const Value& value, qint64 utc_ms);
    /// Everything is unavailable: the source is silent.
    void setAllUnavailable(qint64 utc_ms);

    [[nodiscard]] quint64 firstSequence() const { return m_buffer.empty() ? m_next : m_buffer.front().sequence; }
    [[nodiscard]] quint64 nextSequence() const { return m_next; }
    [[nodiscard]] std::size_t capacity() const { return m_capacity; }
    [[nodiscard]] quint64 instance() const { return m_instance; }
    /// @pre firstSequence() <= sequence < nextSequence()
    [[nodiscard]] const Observation& at(quint64 sequence) const {
        return m_buffer[sequence - m_buffer.front().sequence];
    }
    /// The last observation of an item (of a condition: one per condition that stands).
    [[nodiscard]] const std::vector<Observation>& newest(const DataItem& item) const { return m_newest.at(item.id); }
    [[nodiscard]] const Value& value(const char* id) const { return m_values.at(id); }
    [[nodiscard]] qint64 changed_utc_ms(const char* id) const { return m_newest.at(id).front().utc_ms; }

 private:
    void append(Observation observation);

    std::size_t m_capacity;
    quint64 m_instance;
    quint64 m_next{1};
    std::deque<Observation> m_buffer;
    std::map<std::string, Value> m_values;
    std::map<std::string, std::vector<Observation>> m_newest;
};

}  // namespace kerf::gateway
