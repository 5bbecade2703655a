// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCommandLineParser>
#include <QCoreApplication>
#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>
#include <QRandomGenerator>
#include <QSslCertificate>
#include <QSslKey>
#include <csignal>
#include <cstdio>
#include <optional>

#include "app/gateway/gateway.h"
#include "app/gateway/shdr_server.h"

namespace {

constexpr int kWrongUsage = 2;
constexpr int kBadInput = 3;

struct Options {
    kerf::gateway::GatewayOptions gateway{};
    int httpPort{5000};
    int shdrPort{0};
    std::string address{"127.0.0.1"};
    std::string certificate{};
    std::string key{};
    std::string tokens{};
};

int complain(const QString& sentence) {
    std::fprintf(stderr, "kerf-gateway: %s\n", qPrintable(sentence));
    return kBadInput;
}

/// A token for one device: the token to type there, and the line for the file, which holds only its hash.
int printToken(const std::string& device) {
    QByteArray bytes(32, '\0');
    QRandomGenerator::system()->generate(bytes.begin(), bytes.end());
    const QByteArray token = bytes.toBase64(QByteArray::Base64UrlEncoding | QByteArray::OmitTrailingEquals);
    const QByteArray hash = QCryptographicHash::hash(token, QCryptographicHash::Sha256).toHex();
    std::fprintf(stderr, "token of %s (shown once): %s\n", device.c_str(), token.constData());
    std::printf("%s %s\n", hash.constData(), device.c_str());
    return 0;
}

/// Lines "HASH DEVICE"; empty when the file cannot be used.
std::vector<QByteArray> readTokens(const std::string& path) {
    std::vector<QByteArray> hashes;
    QFile file(QString::fromStdString(path));
    if (file.open(QIODevice::ReadOnly)) {
        for (const QByteArray& line : file.readAll().split('\n')) {
            const QByteArray hash = line.trimmed().split(' ').front();
            if (hash.size() == 64 && QByteArray::fromHex(hash).size() == 32) {
                hashes.push_back(hash.toLower());
            }
        }
    }
    return hashes;
}

std::optional<QSslConfiguration> tlsOf(const Options& options) {
    const QList<QSslCertificate> chain = QSslCertificate::fromPath(QString::fromStdString(options.certificate));
    QFile file(QString::fromStdString(options.key));
    if (chain.isEmpty() || !file.open(QIODevice::ReadOnly)) {
        return std::nullopt;
    }
    const QByteArray pem = file.readAll();
    QSslKey key(pem, QSsl::Ec);
    if (key.isNull()) {
        key = QSslKey(pem, QSsl::Rsa);
    }
    if (key.isNull()) {
        return std::nullopt;
    }
    QSslConfiguration tls = QSslConfiguration::defaultConfiguration();
    tls.setLocalCertificateChain(chain);
    tls.setPrivateKey(key);
    tls.setProtocol(QSsl::TlsV1_2OrLater);
    tls.setPeerVerifyMode(QSslSocket::VerifyNone);  // devices are known by their tokens
    return tls;
}

int serve(Options options) {
    using namespace kerf::gateway;
    const QHostAddress address(QString::fromStdString(options.address));
    if (address.isNull()) {
        return complain(QStringLiteral("--listen %1: expected an address such as 127.0.0.1 or 0.0.0.0")
                            .arg(QString::fromStdString(options.address)));
    }
    std::optional<QSslConfiguration> tls;
    if (!options.certificate.empty() || !options.key.empty()) {
        tls = tlsOf(options);
        if (!tls) {
            return complain(QStringLiteral("--certificate and --key: expected a certificate and its key as PEM files"));
        }
    }
    if (!options.tokens.empty()) {
        options.gateway.tokenHashes = readTokens(options.tokens);
        if (options.gateway.tokenHashes.empty()) {
            return complain(QStringLiteral("--tokens %1: expected lines as --new-token prints them")
                                .arg(QString::fromStdString(options.tokens)));
        }
    }
    if (!address.isLoopback() && (!tls || options.gateway.tokenHashes.empty())) {
        return complain(QStringLiteral("--listen %1: beyond 127.0.0.1 only with --certificate, --key and --tokens")
                            .arg(QString::fromStdString(options.address)));
    }
    Gateway gateway(options.gateway);
    HttpServer http([&gateway](const HttpRequest& request, HttpClient& client) { gateway.serve(request, client); });
    if (!http.listen(address, static_cast<quint16>(options.httpPort), tls)) {
        return complain(QStringLiteral("--http %1: %2").arg(options.httpPort).arg(http.fault()));
    }
    std::fprintf(stdout, "http %d\n", http.port());
    ShdrServer shdr(gateway.observations());
    QObject::connect(&gateway, &Gateway::looked, &shdr, &ShdrServer::update);
    if (options.shdrPort >= 0) {
        if (!shdr.listen(static_cast<quint16>(options.shdrPort))) {
            return complain(QStringLiteral("--shdr %1: the port cannot be had").arg(options.shdrPort));
        }
        std::fprintf(stdout, "shdr %d\n", shdr.port());
    }
    std::fflush(stdout);
    return QCoreApplication::exec();
}

/// A whole number of the command line; nothing when it is none or outside.
std::optional<int> numberOf(const QCommandLineParser& parser, const QString& name, int low, int high) {
    bool good = false;
    const int value = parser.value(name).toInt(&good);
    if (!good || value < low || value > high) {
        std::fprintf(stderr, "kerf-gateway: --%s: expected a whole number from %d to %d\n", qPrintable(name), low,
                     high);
        return std::nullopt;
    }
    return value;
}

}  // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("kerf-gateway"));
    std::signal(SIGPIPE, SIG_IGN);
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "One console for everybody else, read only: MTConnect 2.7 (/probe, /current, /sample, /assets), SHDR, and a "
        "board\n"
        "for desk, wall and phone at /. The ports in use are printed. Exit 2 wrong usage, 3 bad input."));
    const QCommandLineOption help = parser.addHelpOption();
    const auto add = [&parser](const char* name, const char* text, const char* value, const char* standard) {
        parser.addOption({QLatin1String(name), QLatin1String(text), QLatin1String(value), QLatin1String(standard)});
    };
    add("data", "Data folder of the console (default: the user's)", "FOLDER", "");
    add("http", "Port of MTConnect and board; 0: any free one", "PORT", "5000");
    add("shdr", "Port of SHDR, on 127.0.0.1; 0: any free one, -1: none", "PORT", "-1");
    add("listen", "Address of --http; beyond 127.0.0.1 only with TLS and tokens", "ADDRESS", "127.0.0.1");
    add("certificate", "Certificate (PEM) for TLS", "FILE", "");
    add("key", "Its key (PEM)", "FILE", "");
    add("tokens", "File with one device's token hash a line", "FILE", "");
    add("new-token", "Prints a token for this device and its line for --tokens, and ends", "DEVICE", "");
    add("period", "Time between two looks at the console, ms", "MS", "100");
    add("buffer", "Observations kept for /sample", "NUMBER", "131072");
    if (!parser.parse(QCoreApplication::arguments()) || !parser.positionalArguments().isEmpty()) {
        std::fprintf(stderr, "kerf-gateway: %s\n",
                     qPrintable(parser.errorText().isEmpty() ? QStringLiteral("only options are expected")
                                                             : parser.errorText()));
        return kWrongUsage;
    }
    if (parser.isSet(help)) {
        std::fputs(qPrintable(parser.helpText()), stdout);
        return 0;
    }
    const auto text = [&parser](const char* name) { return parser.value(QLatin1String(name)).toStdString(); };
    if (parser.isSet(QStringLiteral("new-token"))) {
        return printToken(text("new-token"));
    }
    const auto http = numberOf(parser, QStringLiteral("http"), 0, 65535);
    const auto shdr = numberOf(parser, QStringLiteral("shdr"), -1, 65535);
    const auto period = numberOf(parser, QStringLiteral("period"), 1, 500);
    const auto buffer = numberOf(parser, QStringLiteral("buffer"), 64, 10'000'000);
    if (!http || !shdr || !period || !buffer) {
        return kWrongUsage;
    }
    Options options;
    options.gateway.dataFolder = text("data");
    options.gateway.bufferSize = static_cast<std::size_t>(*buffer);
    options.gateway.period_ms = *period;
    options.httpPort = *http;
    options.shdrPort = *shdr;
    options.address = text("listen");
    options.certificate = text("certificate");
    options.key = text("key");
    options.tokens = text("tokens");
    if (!options.gateway.dataFolder.empty() && !QFileInfo::exists(parser.value(QStringLiteral("data")))) {
        return complain(QStringLiteral("--data %1: there is no such folder").arg(parser.value(QStringLiteral("data"))));
    }
    return serve(std::move(options));
}
