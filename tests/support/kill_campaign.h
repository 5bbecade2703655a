// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QProcess>
#include <QStringList>
#include <chrono>
#include <csignal>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "engine/core/random.h"

namespace kerf::test {

/// Kills a program at a random moment while it works, as often as asked, and lets the caller look at what is left.
///
/// The program writes one line per thing it has safely stored (after `ackWord`) on its standard output, in one write()
/// each.
/// After a seeded number of such lines and a seeded spin of up to `maxSpin_us` it gets SIGKILL: between two commits, in
/// the middle of one, or in the middle of a checkpoint. Lines it wrote before it died are all delivered to `check`.
class KillCampaign {
 public:
    struct Options {
        QString program{};
        QStringList arguments{};
        /// Called before each round; what it gives is appended to the arguments (a folder of its own). May be empty.
        std::function<QStringList(int round)> prepare{};
        const char* ackWord{"ack "};
        int rounds{10};
        std::uint64_t seed{1};
        int minAcks{1};  ///< at least so many lines before the kill
        int maxAcks{25};
        int maxSpin_us{3000};
        int startTimeout_ms{120000};  ///< for the first lines to come
    };
    /// What a killed run had acknowledged, in order. Return an empty text when all is well, else what is wrong.
    using Check = std::function<QString(int round, const std::vector<std::string>& acks)>;

    /// Empty when every round was well; else the first finding with its round.
    [[nodiscard]] static QString run(const Options& options, const Check& check) {
        Random random(options.seed);
        for (int round = 0; round < options.rounds; ++round) {
            const int wanted =
                options.minAcks + static_cast<int>(random.uniform() * (options.maxAcks - options.minAcks + 1));
            const auto spin =
                std::chrono::microseconds(static_cast<std::int64_t>(random.uniform() * options.maxSpin_us));
            std::vector<std::string> acks;
            const QStringList arguments =
                options.arguments + (options.prepare ? options.prepare(round) : QStringList());
            const QString trouble = oneRound(options, arguments, wanted, spin, acks);
            const QString finding = trouble.isEmpty() ? check(round, acks) : trouble;
            if (!finding.isEmpty()) {
                return QStringLiteral("round %1 of seed %2: %3").arg(round).arg(options.seed).arg(finding);
            }
        }
        return {};
    }

 private:
    static QString oneRound(const Options& options, const QStringList& arguments, int wanted,
                            std::chrono::microseconds spin, std::vector<std::string>& acks) {
        QProcess process;
        process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        process.start(options.program, arguments, QIODevice::ReadOnly);
        if (!process.waitForStarted(options.startTimeout_ms)) {
            return QStringLiteral("does not start: ") + process.errorString();
        }
        QByteArray rest;
        while (static_cast<int>(acks.size()) < wanted) {
            if (process.bytesAvailable() == 0 && !process.waitForReadyRead(options.startTimeout_ms)) {
                return QStringLiteral("ended or stood still by itself: ") + process.errorString();
            }
            take(process, options.ackWord, rest, acks);
        }
        const auto until = std::chrono::steady_clock::now() + spin;
        while (std::chrono::steady_clock::now() < until) {
        }
        ::kill(static_cast<pid_t>(process.processId()), SIGKILL);
        process.waitForFinished(options.startTimeout_ms);
        if (process.exitStatus() != QProcess::CrashExit) {
            return QStringLiteral("ended by itself before it was killed");
        }
        take(process, options.ackWord, rest, acks);
        return {};
    }

    static void take(QProcess& process, const char* ackWord, QByteArray& rest, std::vector<std::string>& acks) {
        rest += process.readAllStandardOutput();
        for (qsizetype end = rest.indexOf('\n'); end >= 0; end = rest.indexOf('\n')) {
            const QByteArray line = rest.left(end);
            rest.remove(0, end + 1);
            if (line.startsWith(ackWord)) {
                acks.push_back(line.mid(static_cast<qsizetype>(std::strlen(ackWord))).toStdString());
            }
        }
    }
};

}  // namespace kerf::test
