// Meshes, drawings and texts of the model, made by the program itself in a process of its own: however long that takes,
// the window goes on, and it can be ended at any moment.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ui/viewer/latest_job.h"
#include "ui/viewer/revision.h"

namespace ui {

struct Exported {
    std::filesystem::path path;
    bool good = false;
    std::string text;  ///< What the program said.
};

/// What the program is given to write the file: the source with its definitions and customized values.
[[nodiscard]] std::vector<std::string> export_arguments(const Source& source, const std::filesystem::path& path);

/// One at a time, in a thread that waits for it.
class ExportJob {
  public:
    /// `wake` is called from another thread when take() has something.
    explicit ExportJob(std::function<void()> wake) : job_(std::move(wake)) {}

    /// `more`: further arguments.
    void start(const Source& source, const std::filesystem::path& path, const std::vector<std::string>& more = {});
    void cancel() { job_.cancel(); }
    [[nodiscard]] bool busy() const { return job_.busy(); }
    [[nodiscard]] std::optional<Exported> take() { return job_.take(); }

  private:
    LatestJob<Exported> job_;
};

}  // namespace ui
