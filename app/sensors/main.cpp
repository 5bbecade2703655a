// SPDX-License-Identifier: GPL-3.0-or-later
// kerf-sensors: reads the sensors of one machine and hands them over in shared memory. Started by the console and by
// `kerf sensors`; ends with them (end of its standard input), or with a signal.
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <QCoreApplication>
#include <QLoggingCategory>
#include <QSocketNotifier>
#include <csignal>
#include <cstdio>
#include <new>

#include "app/sensors/sensor_poller.h"

namespace {

using kerf::sensors::SensorMemory;

constexpr int kDone = 0;
constexpr int kProgramFault = 1;
constexpr int kWrongUsage = 2;
constexpr int kBadInput = 3;

int g_wake = -1;  ///< writing to it ends the event loop
void onSignal(int /*signal*/) {
    const char byte = 'x';
    (void)!write(g_wake, &byte, 1);
}

SensorMemory* openMemory(const std::string& name) {
    (void)shm_unlink(name.c_str());  // a reader that holds the last one's memory finds this one
    const int file = shm_open(name.c_str(), O_RDWR | O_CREAT | O_EXCL, 0600);
    if (file < 0 || ftruncate(file, sizeof(SensorMemory)) != 0) {
        return nullptr;
    }
    void* block = mmap(nullptr, sizeof(SensorMemory), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    close(file);
    return block == MAP_FAILED ? nullptr : new (block) SensorMemory();
}

int run(int argc, char** argv) {
    std::string path;
    std::string memoryName;
    CLI::App options("Kerf's reading process: polls the modules of a sensor file and hands their values over.",
                     "kerf-sensors");
    options.add_option("file", path, "Sensor file (docs/sensors.md)")->required();
    options.add_option("--memory", memoryName, "Name of the shared memory to make, as /kerf-sensors-1")->required();
    try {
        options.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return options.exit(error) == 0 ? kDone : kWrongUsage;
    }
    QLoggingCategory::setFilterRules(QStringLiteral("qt.modbus*=false"));
    QCoreApplication application(argc, argv);
    kerf::sensors::SensorFile file = kerf::sensors::readSensorFile(path);
    SensorMemory* memory = openMemory(memoryName);
    int wake[2] = {-1, -1};
    if (memory == nullptr || pipe2(wake, O_CLOEXEC | O_NONBLOCK) != 0) {
        std::fprintf(stderr, "kerf-sensors: %s: no shared memory of that name can be made.\n", memoryName.c_str());
        return kProgramFault;
    }
    g_wake = wake[1];
    std::signal(SIGTERM, onSignal);
    std::signal(SIGINT, onSignal);
    memory->fingerprint = file.fingerprint;
    kerf::sensors::SensorPoller poller(std::move(file), *memory);
    QSocketNotifier ended(wake[0], QSocketNotifier::Read);
    QObject::connect(&ended, &QSocketNotifier::activated, &application, &QCoreApplication::quit);
    // Our parent speaks to us over standard input: "ask N"; its end is our end.
    QSocketNotifier parent(STDIN_FILENO, QSocketNotifier::Read);
    std::string text;
    QObject::connect(&parent, &QSocketNotifier::activated, &application, [&] {
        char buffer[256];
        const auto count = read(STDIN_FILENO, buffer, sizeof buffer);
        if (count <= 0) {
            QCoreApplication::quit();
            return;
        }
        text.append(buffer, static_cast<std::size_t>(count));
        for (auto end = text.find('\n'); end != std::string::npos; end = text.find('\n')) {
            unsigned index = 0;
            if (std::sscanf(text.c_str(), "ask %u", &index) == 1) {
                (void)poller.askGauge(index);
            }
            text.erase(0, end + 1);
        }
    });
    poller.start();
    memory->magic.store(SensorMemory::kMagic, std::memory_order_release);
    const int code = QCoreApplication::exec();
    memory->magic.store(0, std::memory_order_release);
    (void)shm_unlink(memoryName.c_str());
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const kerf::sensors::SensorFileFault& fault) {
        std::fprintf(stderr, "kerf-sensors: %s\n", fault.what());
        return kBadInput;
    } catch (const std::exception& fault) {
        std::fprintf(stderr, "kerf-sensors: %s\n", fault.what());
        return kProgramFault;
    }
}
