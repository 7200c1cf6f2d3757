#include <gtest/gtest.h>

#include "npr/style.h"
#include "ui/command_line/files.h"
#include "ui/command_line/options.h"
#include "ui/pipeline/suggestion.h"

namespace ui {
namespace {

Options read(const std::vector<std::string>& arguments) {
    return read_command_line(arguments).options;
}

std::string error(const std::vector<std::string>& arguments) {
    try {
        (void)read_command_line(arguments);
    } catch (const UsageError& e) {
        return e.what();
    }
    return "no error";
}

TEST(Options, DefaultsAreOpenscads) {
    const Options o = read({"a.scad"});
    EXPECT_EQ(o.input, "a.scad");
    EXPECT_TRUE(o.outputs.empty());
    EXPECT_EQ(o.picture.size, glm::ivec2(512, 512));
    EXPECT_EQ(o.picture_texts.scheme, "Cornfield");
    EXPECT_FALSE(o.camera);
    EXPECT_TRUE(o.preview);
    EXPECT_EQ(o.projection, base::Projection::Perspective);
}

TEST(Options, OutputsAreReadBySuffixInAnyOrder) {
    const Options o = read({"-o", "a.png", "m.scad", "-ob.csg", "--o=c.ECHO", "-o", "d.ast"});
    ASSERT_EQ(o.outputs.size(), 4U);
    EXPECT_EQ(o.outputs[0].format, Format::Png);
    EXPECT_EQ(o.outputs[1].path, "b.csg");
    EXPECT_EQ(o.outputs[1].format, Format::Csg);
    EXPECT_EQ(o.outputs[2].format, Format::Echo);
    EXPECT_EQ(o.outputs[3].format, Format::Ast);
    EXPECT_EQ(o.input, "m.scad");
}

/// What `openscad --help` of 2021.01 lists, but --animate, -s and -x.
TEST(Options, OpenscadsOwnAreTaken) {
    for (const std::vector<std::string>& option :
         std::vector<std::vector<std::string>>{{"--export-format", "asciistl"},
                                               {"-D", "x=1"},
                                               {"-p", "sets.json", "-P", "one"},
                                               {"--camera", "0,0,0,0,0,0,50"},
                                               {"--autocenter"},
                                               {"--viewall"},
                                               {"--imgsize", "50,50"},
                                               {"--render="},
                                               {"--preview=throwntogether"},
                                               {"--view", "axes,crosshairs,edges,scales"},
                                               {"--projection", "o"},
                                               {"--csglimit", "5"},
                                               {"--colorscheme", "Nature"},
                                               {"-d", "deps"},
                                               {"-m", "make"},
                                               {"-q"},
                                               {"--hardwarnings"},
                                               {"--check-parameters", "true"},
                                               {"--check-parameter-ranges", "true"},
                                               {"--debug", "all"}}) {
        std::vector<std::string> line{"a.scad", "-o", "a.stl"};
        line.insert(line.end(), option.begin(), option.end());
        EXPECT_EQ(error(line), "no error") << option[0];
    }
}

/// Command lines of paths alone are read without the table of options.
TEST(Options, PathsAloneAreTheSame) {
    const Options o = read({"-o", "a.csg", "m.scad", "-o", "b.ECHO"});
    const Options table = read({"--quiet", "-o", "a.csg", "m.scad", "-o", "b.ECHO"});
    EXPECT_EQ(o.input, table.input);
    ASSERT_EQ(o.outputs.size(), table.outputs.size());
    for (std::size_t i = 0; i < o.outputs.size(); ++i) {
        EXPECT_EQ(o.outputs[i].path, table.outputs[i].path);
        EXPECT_EQ(o.outputs[i].format, table.outputs[i].format);
    }
    EXPECT_EQ(o.picture, table.picture);
    EXPECT_EQ(o.picture_texts, table.picture_texts);
    EXPECT_EQ(o.check_parameters, table.check_parameters);
    EXPECT_EQ(o.trace_parameters, table.trace_parameters);
    EXPECT_EQ(o.trace_depth, table.trace_depth);
    EXPECT_EQ(o.memory_limit, table.memory_limit);
    EXPECT_EQ(o.time_limit, table.time_limit);
    EXPECT_EQ(error({"a.scad", "b.scad"}), error({"--quiet", "a.scad", "b.scad"}));
    EXPECT_EQ(error({"-o", "a.xyz", "b.scad"}), error({"--quiet", "-o", "a.xyz", "b.scad"}));
    EXPECT_EQ(error({"b.scad", "-o"}), error({"--quiet", "b.scad", "-o"}));
    EXPECT_EQ(error({"-o", "-x", "b.scad"}), error({"--quiet", "-o", "-x", "b.scad"}));
    EXPECT_NE(error({"", "b.scad"}), "no error");
}

TEST(Options, ExportFormatWinsOverTheSuffix) {
    const Options o = read({"-o", "-", "--export-format", "png", "m.scad"});
    ASSERT_EQ(o.outputs.size(), 1U);
    EXPECT_EQ(o.outputs[0].path, "-");
    EXPECT_EQ(o.outputs[0].format, Format::Png);
}

TEST(Options, DefinitionsKeepCommasBracketsAndSpaces) {
    const Options o = read({"-D", "size=[1, 2,3]", "-Dname=\"a b\"", "m.scad", "--D=x=-1"});
    EXPECT_EQ(o.definitions, (std::vector<std::string>{"size=[1, 2,3]", "name=\"a b\"", "x=-1"}));
    EXPECT_EQ(o.input, "m.scad");
}

TEST(Options, SevenNumbersAreAGimbalCamera) {
    const Options o = read({"--camera", "-1,2,3.5,40,50,60,70", "--projection=o", "m.scad"});
    ASSERT_TRUE(o.camera);
    EXPECT_EQ(o.camera->target, glm::dvec3(-1, 2, 3.5));
    EXPECT_EQ(o.camera->rotation, glm::dvec3(40, 50, 60));
    EXPECT_EQ(o.camera->distance, 70);
    EXPECT_EQ(o.camera->projection, base::Projection::Orthographic);
}

TEST(Options, SixNumbersAreEyeAndCenter) {
    const Options o = read({"--camera=10,0,0,1,0,0", "m.scad"});
    ASSERT_TRUE(o.camera);
    EXPECT_NEAR(glm::distance(o.camera->eye(), glm::dvec3(10, 0, 0)), 0, 1e-9);
    EXPECT_NEAR(o.camera->distance, 9, 1e-9);
}

TEST(Options, RenderAndPreviewTakeNoFileForTheirValue) {
    EXPECT_EQ(read({"--render", "m.scad"}).input, "m.scad");
    EXPECT_FALSE(read({"--render", "m.scad"}).preview);
    EXPECT_FALSE(read({"--render=force", "m.scad"}).preview);
    EXPECT_TRUE(read({"--preview=throwntogether", "m.scad"}).preview);
}

TEST(Options, LayersAndSettings) {
    EXPECT_EQ(read({"--layers", "all", "m.scad"}).picture.layers, 0);
    EXPECT_EQ(read({"--layers", "3", "m.scad"}).picture.layers, 3);
    const Options o = read({"--set", "ground=paper", "--set", "width=1.5", "m.scad"});
    ASSERT_EQ(o.picture_texts.settings.size(), 2U);
    EXPECT_EQ(o.picture_texts.settings[1], std::pair(std::string("width"), std::string("1.5")));
}

TEST(Options, EnginesByName) {
    EXPECT_EQ(read({"m.scad"}).engine.engine, nullptr);
    EXPECT_EQ(read({"m.scad", "--engine", "auto"}).engine.engine, nullptr);
    for (const goldfeather::EngineInfo& engine : goldfeather::engines()) {
        EXPECT_EQ(read({"m.scad", "--engine", std::string(engine.name)}).engine.engine, &engine);
    }
    EXPECT_EQ(read({"m.scad"}).engine.memory_budget, std::size_t{128} << 20);
    EXPECT_EQ(read({"m.scad", "--memory-budget", "3"}).engine.memory_budget, std::size_t{3} << 20);
    EXPECT_NE(error({"m.scad", "--memory-budget", "0"}).find("--memory-budget"), std::string::npos);
    EXPECT_EQ(read({"m.scad"}).engine.minimal_fraction, 0);
    EXPECT_EQ(read({"m.scad", "--minimal-fraction", "0.001"}).engine.minimal_fraction, 0.001);
    for (const char* wrong : {"-0.1", "1.5", "few"}) {
        EXPECT_NE(error({"m.scad", "--minimal-fraction", wrong}).find("--minimal-fraction"), std::string::npos);
    }
    EXPECT_NE(error({"m.scad", "--engine", "raytracer"}).find("--engine"), std::string::npos);
}

TEST(Options, HelpNamesEveryGroup) {
    const std::string help = read_command_line({"--help"}, style_names()).text.value_or("");
    for (const char* word : {"Input and output", "Picture", "Camera", "Engine", "--style", "--imgsize", "--stats"}) {
        EXPECT_NE(help.find(word), std::string::npos) << word;
    }
    EXPECT_FALSE(read_command_line({"--help"}).text.has_value()) << "there are no styles to list";
    EXPECT_EQ(read_command_line({"-v"}).text.value_or("").substr(0, 17), "csgscope version ");
}

TEST(PictureOptions, AreUnderstoodByTheListsOfStylesAndSchemes) {
    const Options o = read({"--style", "blueprint", "--set", "width=2.5", "--set", "ground=white", "--colorscheme",
                            "Sunset", "--layers", "3", "--samples", "8", "--transparent-background", "m.scad"});
    npr::Picture expected = npr::default_picture();
    expected.draw_as(*npr::find_style("blueprint"));
    expected.parameters.set("width", 2.5F);
    expected.parameters.set("ground", 1);
    expected.scheme = *npr::find_color_scheme("Sunset");
    expected.layers = 3;
    expected.samples = 8;
    expected.transparent_background = true;
    EXPECT_EQ(picture_of(o.picture, o.picture_texts), expected);
    const Options plain = read({"m.scad"});
    EXPECT_EQ(picture_of(plain.picture, plain.picture_texts), npr::default_picture());
}

TEST(PictureOptions, WhatDoesNotExistIsRefused) {
    const auto refusal = [](const PictureTexts& texts) {
        try {
            (void)picture_of({}, texts);
        } catch (const std::runtime_error& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    EXPECT_EQ(refusal({"bluprint", {}, "Cornfield"}), "no style \"bluprint\". Did you mean \"blueprint\"?");
    EXPECT_EQ(refusal({"blueprint", {{"width", "wide"}}, "Cornfield"}),
              "style blueprint: width takes a length up to 1000 in pixels, or in millimeters as 0.35mm, not \"wide\"");
    EXPECT_EQ(refusal({"shaded", {}, "Cornfeld"}), "no color scheme \"Cornfeld\". Did you mean \"Cornfield\"?");
    EXPECT_EQ(refusal({}), "");
}

TEST(Options, BadOnesSayWhatWasExpected) {
    struct Case {
        std::vector<std::string> arguments;
        const char* message;
    };
    const Case cases[] = {
        {{"--imgsize", "10"}, "expected width,height"},
        {{"--imgsize", "0,10"}, "1 to 16384"},
        {{"--imgsize", "10,20000"}, "1 to 16384"},
        {{"--imgsize", "1.5,10"}, "whole number"},
        {{"--imgsize", "10,10x"}, "expected width,height"},
        {{"--imgsize", "nan,1"}, "expected width,height"},
        {{"--imgsize", "1,2,"}, "expected width,height"},
        {{"--camera", "1,2,3"}, "6 numbers"},
        {{"--camera", "1,1,1,1,1,1"}, "same point"},
        {{"--camera", "0,0,0,0,0,0,-5"}, "distance"},
        {{"--camera", "0,0,0,0,0,0,inf"}, "6 numbers"},
        {{"--projection", "x"}, "perspective"},
        {{"--layers", "0"}, "1 to"},
        {{"--layers", "many"}, "whole number"},
        {{"--samples", "5"}, "1, 4, 8, 16"},
        {{"--context", "eggl"}, "Did you mean \"egl\"?"},
        {{"--engine", "godfeather"}, "Did you mean \"goldfeather\"?"},
        {{"--sytle", "edges"}, "Did you mean \"--style\"?"},
        {{"--imgsiez=3,4"}, "Did you mean \"--imgsize\"?"},
        {{"--animate", "5"}, "-o is to name"},
        {{"-o", "a.step"}, "pdf, csg, ast, echo, term and param"},
        {{"-o", "a"}, "suffix"},
        {{"-o", "dir.png/a"}, "suffix"},
        {{"-o", "-"}, "--export-format"},
        {{"-o", "a.png", "--export-format", "step"}, "pdf, csg, ast, echo, term and param"},
        {{"--set", "=1"}, "name=value"},
        {{"-o"}, "-o"},
        {{"b.scad"}, "one input file"},
        {{"--time-limit", "0"}, "above 0"},
        {{"--time-limit", "soon"}, "seconds"},
        {{"--memory-limit", "0"}, "whole number"},
        {{"--trace-depth", "-1"}, "whole number"},
        {{"--check-parameter-ranges", "maybe"}, "on"},
    };
    for (const Case& c : cases) {
        auto arguments = c.arguments;
        arguments.emplace_back("m.scad");
        if (c.arguments == std::vector<std::string>{"-o"}) {
            arguments = c.arguments;
        }
        EXPECT_NE(error(arguments).find(c.message), std::string::npos)
            << arguments[0] << " gives: " << error(arguments);
    }
}

TEST(Suggestion, IsTheNearestName) {
    const std::vector<std::string> names = {"shaded", "edges", "blueprint"};
    EXPECT_EQ(suggestion("bluprint", names), " Did you mean \"blueprint\"?");
    EXPECT_EQ(suggestion("Edges", names), " Did you mean \"edges\"?");
    EXPECT_EQ(suggestion("qqqqqqqq", names, " No."), " No.");
}

TEST(DependencyRules, EscapeWhatMakeWouldRead) {
    EXPECT_EQ(dependency_rules({"a b.png"}, {"x$y.scad", "z.scad"}), "a\\ b.png: \\\n\tx$$y.scad \\\n\tz.scad\n");
}

}  // namespace
}  // namespace ui
