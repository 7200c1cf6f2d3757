#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "ui/viewer/customizer_panel.h"

namespace ui {

namespace {

using Parameter = csg::scad::CustomizerParameter;
constexpr const char* kId = "##value";

/// With as many digits as the steps need.
std::string number_format(const Parameter& parameter) {
    constexpr int kMostDigits = 6;
    const double step = parameter.step.value_or(0);
    int digits = 0;
    for (double scaled = step; digits < kMostDigits && std::abs(scaled - std::round(scaled)) > 1e-9; scaled *= 10) {
        ++digits;
    }
    return step > 0 ? fmt::format("%.{}f", digits) : "%.6g";
}

bool has_range(const Parameter& parameter) {
    return parameter.minimum && parameter.maximum && *parameter.minimum < *parameter.maximum;
}

double within(const Parameter& parameter, double number) {
    number = parameter.maximum ? std::min(number, *parameter.maximum) : number;
    return parameter.minimum ? std::max(number, *parameter.minimum) : number;
}

bool draw_options(const Parameter& parameter, Parameter::Value& value) {
    const auto same = [&](const Parameter::Option& option) {
        return std::visit([&](const auto& v) { return value == Parameter::Value(v); }, option.value);
    };
    const auto chosen = std::ranges::find_if(parameter.options, same);
    bool changed = false;
    if (ImGui::BeginCombo(kId, chosen == parameter.options.end() ? "" : chosen->label.c_str())) {
        for (std::size_t i = 0; i < parameter.options.size(); ++i) {
            const Parameter::Option& option = parameter.options[i];
            ImGui::PushID(static_cast<int>(i));
            if (ImGui::Selectable(option.label.c_str(), same(option)) && !same(option)) {
                value = std::visit([](const auto& v) { return Parameter::Value(v); }, option.value);
                changed = true;
            }
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
    return changed;
}

bool draw_number(const Parameter& parameter, double& number) {
    const double before = number;
    const std::string format = number_format(parameter);
    if (has_range(parameter)) {
        ImGui::SliderScalar(kId, ImGuiDataType_Double, &number, &*parameter.minimum, &*parameter.maximum,
                            format.c_str(), ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat);
        number = number == before ? before : on_step(parameter, number);
    } else {
        ImGui::InputDouble(kId, &number, parameter.step.value_or(1), 0, "%.10g");
        number = within(parameter, number);
    }
    return number != before && std::isfinite(number);
}

bool draw_numbers(const Parameter& parameter, std::vector<double>& numbers) {
    const std::vector<double> before = numbers;
    const int count = static_cast<int>(numbers.size());
    if (has_range(parameter)) {
        ImGui::SliderScalarN(kId, ImGuiDataType_Double, numbers.data(), count, &*parameter.minimum, &*parameter.maximum,
                             number_format(parameter).c_str(),
                             ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat);
    } else {
        ImGui::InputScalarN(kId, ImGuiDataType_Double, numbers.data(), count, nullptr, nullptr, "%.6g");
    }
    bool finite = true;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        numbers[i] = numbers[i] == before[i] ? before[i]
                     : has_range(parameter)  ? on_step(parameter, numbers[i])
                                             : within(parameter, numbers[i]);
        finite = finite && std::isfinite(numbers[i]);
    }
    return finite && numbers != before;
}

/// Without what is more than `longest` characters of UTF-8.
void shorten(std::string& text, std::size_t longest) {
    std::size_t characters = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool begins = (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
        if (begins && characters++ == longest) {
            text.resize(i);
            return;
        }
    }
}

bool draw_text(const Parameter& parameter, std::string& text) {
    const std::string before = text;
    ImGui::InputText(kId, &text);
    if (parameter.longest) {
        shorten(text, *parameter.longest);
    }
    return text != before;
}

}  // namespace

double on_step(const Parameter& parameter, double number) {
    const double step = parameter.step.value_or(0);
    if (step > 0 && parameter.minimum) {
        number = *parameter.minimum + std::round((number - *parameter.minimum) / step) * step;
    }
    return within(parameter, number);
}

bool draw_customized(const Parameter& parameter, Parameter::Value& value) {
    if (!parameter.options.empty()) {
        return draw_options(parameter, value);
    }
    if (auto* const truth = std::get_if<bool>(&value)) {
        return ImGui::Checkbox(kId, truth);
    }
    if (auto* const number = std::get_if<double>(&value)) {
        return draw_number(parameter, *number);
    }
    if (auto* const numbers = std::get_if<std::vector<double>>(&value)) {
        return draw_numbers(parameter, *numbers);
    }
    return draw_text(parameter, std::get<std::string>(value));
}

}  // namespace ui
