// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/parts/part_export.h"

#include <QDir>
#include <QFileInfo>
#include <QSaveFile>

namespace kerf::ui {
namespace {

Result<std::uint64_t> write(const PartExport::OpenReader& open, const PartExport::OpenVerdicts& openVerdicts,
                            const PartQuery& query, PartExport::What what, const QString& name,
                            const std::atomic<bool>& stop) {
    const std::unique_ptr<PartReader> reader = open();
    if (!reader) {
        return fail(KERF_TEXT("The database cannot be opened for the export."));
    }
    QDir().mkpath(QFileInfo(name).absolutePath());
    QSaveFile file(name);
    if (!file.open(QIODevice::WriteOnly)) {
        return fail(KERF_TEXT("The file cannot be written there. Choose another folder."));
    }
    const CsvSink sink = [&file, &stop](std::string_view text) {
        return !stop && file.write(text.data(), static_cast<qint64>(text.size())) == static_cast<qint64>(text.size());
    };
    // For a spreadsheet: names stay readable, and the time is the one of the clock on the wall.
    CsvFormat format;
    format.byteOrderMark = true;
    format.localTime = true;
    Result<std::uint64_t> rows = 0;
    switch (what) {
        case PartExport::What::Parts:
            rows = exportParts(*reader, query, sink, format, openVerdicts ? openVerdicts() : VerdictOf());
            break;
        case PartExport::What::Measurements:
            rows = exportMeasurements(*reader, query, sink, format);
            break;
        case PartExport::What::Figures:
            rows = exportFigures(*reader, query, sink, format, openVerdicts ? openVerdicts() : VerdictOf());
            break;
        case PartExport::What::Feed:
            rows = exportFeed(*reader, query, sink, format);
            break;
    }
    if (rows && !file.commit()) {
        return fail(KERF_TEXT("The file could not be finished: the disk is full or was taken away."));
    }
    return rows;
}

}  // namespace

PartExport::PartExport(QObject* parent) : QObject(parent) {}

PartExport::~PartExport() {
    if (m_thread != nullptr) {
        m_stop = true;
        m_thread->wait();
        delete m_thread;
    }
}

void PartExport::start(OpenReader open, OpenVerdicts openVerdicts, const PartQuery& query, What what,
                       const QString& file) {
    Q_ASSERT(m_thread == nullptr);
    auto result = std::make_shared<Result<std::uint64_t>>(0);
    m_thread = QThread::create([this, open = std::move(open), openVerdicts = std::move(openVerdicts), query, what, file,
                                result] { *result = write(open, openVerdicts, query, what, file, m_stop); });
    connect(m_thread, &QThread::finished, this, [this, file, result] {
        m_thread->deleteLater();
        m_thread = nullptr;
        if (*result) {
            emit finished(file, **result);
        } else {
            emit failed(result->error());
        }
    });
    m_thread->start();
}

}  // namespace kerf::ui
