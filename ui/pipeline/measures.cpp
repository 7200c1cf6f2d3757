#include "ui/pipeline/measures.h"

#include <map>

#include "csg/solid/dxf_measures.h"
#include "csg/solid/file_text.h"
#include "csg/solid/text_outline.h"

namespace ui {

namespace {

constexpr std::size_t kMostBytes = std::size_t{256} << 20;  // Of a drawing.

using csg::scad::DrawingQuery;
using csg::scad::MeasureWarnings;

class LanguageMeasures : public csg::scad::Measures {
  public:
    std::optional<csg::TextMetrics> text(const csg::Text& text, MeasureWarnings& warnings) override {
        return csg::solid::text_metrics(text, fonts_, warnings.at_call);
    }

    std::optional<csg::FontMetrics> font(const csg::Text& text, MeasureWarnings& warnings) override {
        return csg::solid::font_metrics(text, fonts_, warnings.at_call);
    }

    std::optional<double> dimension(const DrawingQuery& query, MeasureWarnings& warnings) override {
        const csg::solid::DxfFile* const file = drawing(query, warnings);
        if (file == nullptr) {
            return std::nullopt;
        }
        csg::solid::Remarks remarks;
        (void)csg::solid::draw_dxf(*file, query.import, remarks);  // Tells what it cannot draw.
        tell(std::move(remarks), warnings);
        return answer(csg::solid::dxf_dimension(*file, query.import, query.dimension, query.file), warnings);
    }

    std::optional<glm::dvec2> cross(const DrawingQuery& query, MeasureWarnings& warnings) override {
        const csg::solid::DxfFile* const file = drawing(query, warnings);
        if (file == nullptr) {
            return std::nullopt;
        }
        csg::solid::Remarks remarks;
        const auto found = csg::solid::dxf_cross(*file, query.import, query.file, remarks);
        tell(std::move(remarks), warnings);
        return answer(found, warnings);
    }

  private:
    static void tell(csg::solid::Remarks remarks, MeasureWarnings& warnings) {
        for (auto* texts : {&remarks.warnings, &remarks.failures}) {
            warnings.of_file.insert(warnings.of_file.end(), texts->begin(), texts->end());
        }
    }

    /// Null, with a warning, where it cannot be read.
    const csg::solid::DxfFile* drawing(const DrawingQuery& query, MeasureWarnings& warnings) {
        const csg::FileStamp& stamp = query.import.file;
        Drawing& known = drawings_[stamp.path];
        if (known.stamp == stamp) {
            return &known.file;
        }
        const auto text = csg::solid::read_file(stamp.path, kMostBytes, warnings.at_call);
        if (!text) {
            return nullptr;
        }
        known = {stamp, csg::solid::read_dxf_file(*text)};
        return &known.file;
    }

    template <typename T>
    static std::optional<T> answer(const csg::solid::Measured<T>& measured, MeasureWarnings& warnings) {
        if (!measured.value) {
            warnings.at_call.push_back(measured.problem);
        }
        return measured.value;
    }

    struct Drawing {
        csg::FileStamp stamp;
        csg::solid::DxfFile file;
    };
    csg::solid::FontLibrary fonts_;
    std::map<std::string, Drawing> drawings_;
};

}  // namespace

std::shared_ptr<csg::scad::Measures> make_measures() {
    return std::make_shared<LanguageMeasures>();
}

}  // namespace ui
