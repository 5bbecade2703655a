// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThread>
#include <atomic>
#include <functional>
#include <memory>

#include "db/api/csv_export.h"
#include "db/api/part_reader.h"

namespace kerf::ui {

/// Writes parts as CSV on a worker with a reader of its own, so that a long history blocks no screen. The file appears
/// under its name when it is whole, never half.
class PartExport : public QObject {
    Q_OBJECT
 public:
    enum class What { Parts, Measurements, Figures, Feed };
    using OpenReader = std::function<std::unique_ptr<PartReader>()>;
    /// Makes, on the worker, who judges the parts for the file; may be empty.
    using OpenVerdicts = std::function<VerdictOf()>;

    explicit PartExport(QObject* parent = nullptr);
    ~PartExport() override;

    /// @pre !running()
    void start(OpenReader open, OpenVerdicts openVerdicts, const PartQuery& query, What what, const QString& file);
    [[nodiscard]] bool running() const { return m_thread != nullptr; }

 signals:
    void finished(const QString& file, qulonglong rows);
    void failed(const kerf::Sentence& why);

 private:
    QThread* m_thread{nullptr};
    std::atomic<bool> m_stop{false};
};

}  // namespace kerf::ui
