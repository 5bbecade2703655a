// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/labelled_table.h"

#include <fmt/format.h>

namespace kerf::headless {

LabelledTable LabelledTable::read(const std::string& path, const ReadOptions& options) {
    std::vector<std::string> cells;
    Table table = Table::read(path, options, &cells);
    LabelledTable out(std::move(table));
    out.m_cells = std::move(cells);
    return out;
}

std::size_t LabelledTable::column(std::string_view name) const {
    if (const auto found = m_table.find(name)) {
        return *found;
    }
    (void)m_table.hasGaps(name);  // says what is missing and what there is
    return 0;
}

std::size_t LabelledTable::valueColumn(std::string_view name) const {
    return m_table.names().size() == 1 && !has(name) ? 0 : column(name);
}

std::vector<double> LabelledTable::numbers(std::size_t column) const {
    return m_table.column(column);
}

void LabelledTable::dropGaps(std::size_t column) {
    const std::size_t width = m_table.names().size();
    std::vector<std::string> kept;
    for (std::size_t row = 0; row < rows(); ++row) {
        if (m_table.kind(row, column) == files::CellKind::Number) {
            for (std::size_t k = 0; k < width; ++k) {
                kept.push_back(std::move(m_cells[row * width + k]));
            }
        }
    }
    m_table.dropRowsWithGaps({m_table.names()[column]});
    m_cells = std::move(kept);
}

}  // namespace kerf::headless
