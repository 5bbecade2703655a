// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

/// Where the console cannot start it says so in one sentence and ends with 3: never by abort().
class TestConsoleRefused : public QObject {
    Q_OBJECT

    struct Ended {
        int code{-1};
        QString words{};
    };
    static Ended start(const QByteArray& folder, QProcessEnvironment environment) {
        QProcess console;
        environment.insert(QStringLiteral("XDG_RUNTIME_DIR"), QDir::tempPath());
        console.setProcessEnvironment(environment);
        // Through a shell: QProcess would take a name that is not UTF-8 for another one.
        QByteArray command("exec \"$KERF_BIN/kerf-console\" --data \"$(printf '");
        for (const char byte : folder) {
            command += "\\" + QByteArray::number(static_cast<unsigned char>(byte), 8).rightJustified(3, '0');
        }
        command += "')\"";
        console.start(QStringLiteral("/bin/sh"), {QStringLiteral("-c"), QString::fromLatin1(command)});
        if (!console.waitForFinished(60'000)) {
            console.kill();
            console.waitForFinished();
            return {};
        }
        return {console.exitStatus() == QProcess::NormalExit ? console.exitCode() : -1,
                QString::fromUtf8(console.readAllStandardError()).trimmed()};
    }
    static QProcessEnvironment offscreen() {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
        return environment;
    }
    static void refused(const Ended& ended, const QString& about) {
        QCOMPARE(ended.code, 3);
        QCOMPARE(ended.words.count(u'\n'), 0);
        QVERIFY2(ended.words.startsWith(QStringLiteral("kerf-console: ")) && ended.words.contains(about),
                 qPrintable(ended.words));
    }

 private slots:
    void aLogThatCannotBeOpened() {
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("kerf.log")));
        refused(start(folder.path().toUtf8(), offscreen()), QStringLiteral("kerf.log"));
    }
    void aDataFolderThatIsAFile() {
        const QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("data")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        refused(start(file.fileName().toUtf8(), offscreen()), QStringLiteral("data folder"));
    }
    void aNameInAnotherEncoding() {
        const QTemporaryDir folder;
        refused(start(folder.path().toUtf8() + "/\xb5\xa5", offscreen()), QStringLiteral("UTF-8"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), 0);
    }
    void noDisplay() {
        const QTemporaryDir folder;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"QT_QPA_PLATFORM", "DISPLAY", "WAYLAND_DISPLAY"}) {
            environment.remove(QLatin1String(name));
        }
        refused(start(folder.path().toUtf8(), environment), QStringLiteral("No display"));
    }
};

QTEST_GUILESS_MAIN(TestConsoleRefused)
#include "tst_console_refused.moc"
