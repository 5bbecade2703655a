// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Reads the keys of one JSON object strictly: every complaint is one sentence that begins with the key's path. Only
/// for .cpp files.
namespace kerf::sensors {

using Json = nlohmann::ordered_json;

/// @throws SensorFileFault with line and column; also for a key that stands twice in an object
[[nodiscard]] Json parseStrictly(const std::string& text);

/// Of a text from a file, as a sentence of one line has room for it: 40 bytes at the most, no control characters.
[[nodiscard]] std::string brief(const std::string& text);

class JsonKeys {
 public:
    /// @param where path of the object, "modules[2]"; empty for the whole file. @throws SensorFileFault: no object
    JsonKeys(const Json& object, std::string where);

    /// @throws SensorFileFault naming the first key that is none of these
    void only(std::initializer_list<const char*> known, const char* ofWhat) const;
    [[nodiscard]] bool has(const std::string& key) const { return m_object.contains(key); }
    [[nodiscard]] std::string path(const std::string& key) const;
    /// @throws SensorFileFault when it is missing
    [[nodiscard]] const Json& value(const std::string& key) const;
    [[nodiscard]] std::string text(const std::string& key) const;
    [[nodiscard]] std::string text(const std::string& key, const std::string& otherwise) const;
    /// A text of 1 to 22 characters that a screen and a sentence have room for.
    [[nodiscard]] std::string name(const std::string& key) const;
    [[nodiscard]] int integer(const std::string& key, int low, int high) const;
    [[nodiscard]] int integer(const std::string& key, int low, int high, int otherwise) const {
        return has(key) ? integer(key, low, high) : otherwise;
    }
    [[nodiscard]] double number(const std::string& key, double low, double high, double otherwise) const;
    /// true or false.
    [[nodiscard]] bool flag(const std::string& key, bool otherwise) const;
    [[nodiscard]] std::vector<double> numbers(const std::string& key, double low, double high, bool whole) const;
    [[nodiscard]] const Json& list(const std::string& key) const;

    template <class T>
    [[nodiscard]] T choice(const std::string& key, std::initializer_list<std::pair<const char*, T>> choices,
                           std::optional<T> otherwise = std::nullopt) const {
        if (otherwise && !has(key)) {
            return *otherwise;
        }
        const std::string word = text(key);
        std::vector<std::string> words;
        for (const auto& [known, meaning] : choices) {
            if (word == known) {
                return meaning;
            }
            words.emplace_back(known);
        }
        refuseWord(key, word, words);
    }
    /// One of these words.
    [[nodiscard]] std::string oneOf(const std::string& key, const std::vector<std::string>& words) const {
        std::string word = text(key);
        if (std::ranges::find(words, word) == words.end()) {
            refuseWord(key, word, words);
        }
        return word;
    }

 private:
    [[noreturn]] void refuseWord(const std::string& key, const std::string& word,
                                 const std::vector<std::string>& words) const;

    const Json& m_object;
    std::string m_where;
};

}  // namespace kerf::sensors
