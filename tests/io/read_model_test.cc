// SPDX-License-Identifier: LGPL-3.0-or-later
// The front door: the table of formats, every format by name, ending and content, and what is refused.
#include "io/read_model.h"

#include <map>
#include <set>

#include "io/formats.h"
#include "io/micro/write_micro.h"
#include "tests/io/io_test_util.h"
#include "tests/support/paths.h"
#include "verify/format/sha256.h"

namespace veritope {
namespace {

using io_test::TempFolder;
using namespace std::string_literals;

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::string spline_sample(const std::string& name) {
  return io_test::slurp(test::source_dir() + "/tests/models/splines/" + name);
}

/// A file of each format, by the name of the format.
const std::map<std::string, std::string>& samples() {
  static const std::map<std::string, std::string> texts = {
      {"stl",
       "solid\nfacet outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\n"
       "endsolid\n"},
      {"obj", kObj},
      {"ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
       "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
       "0 0 0 1 0 0 0 1 0 3 0 1 2\n"},
      {"off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"itd", spline_sample("groups.itd")},
      {"g2", spline_sample("objects.g2")},
      {"mfem", spline_sample("two_cubes.mesh")},
      {"gismo", spline_sample("surface.xml")},
      {"vjson", spline_sample("triangles.vjson")},
      {"vmicro", io_test::slurp(test::source_dir() + "/tests/models/micro/three_cells.vmicro")},
      {"vdms", io_test::slurp(test::source_dir() + "/tests/models/dms/tetrahedron.vdms")},
  };
  return texts;
}

Result<ModelFile> read_as(const std::string& name, std::string_view text,
                          const ModelReadOptions& options = {}) {
  return read_model_bytes(io_test::bytes(text), name, options);
}

std::string code_of(const Result<ModelFile>& file) {
  return file ? "ok" : code_name(file.error().code);
}

std::string message_of(const Result<ModelFile>& file) {
  return file ? "read" : file.error().message;
}

std::string format_name(const Result<ModelFile>& file) {
  return file ? model_format(format_of(*file)).name : to_string(file.error());
}

bool same_model(const ModelFile& a, const ModelFile& b) {
  if (a.index() != b.index()) return false;
  if (const auto* const splines = std::get_if<SplineFile>(&a))
    return splines->model == std::get<SplineFile>(b).model;
  if (const auto* const micro = std::get_if<MicroFile>(&a))
    return write_micro(micro->micro) == write_micro(std::get<MicroFile>(b).micro);
  if (const auto* const dms = std::get_if<DmsFile>(&a))
    return dms->model == std::get<DmsFile>(b).model;
  const TriangleMesh &m = std::get<MeshFile>(a).mesh, &n = std::get<MeshFile>(b).mesh;
  const auto equal = [](const Vec3d& p, const Vec3d& q) {
    return p.x == q.x && p.y == q.y && p.z == q.z;
  };
  return m.faces == n.faces && std::equal(m.positions.begin(), m.positions.end(),
                                          n.positions.begin(), n.positions.end(), equal);
}

std::string upper(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

TEST(ModelFormats, EveryRowIsCompleteAndNoWordNamesTwoFormats) {
  std::set<std::string> words;
  std::set<FormatId> ids;
  for (const ModelFormat& row : model_formats()) {
    EXPECT_TRUE(ids.insert(row.id).second) << row.name;
    EXPECT_EQ(&model_format(row.id), &row);
    ASSERT_FALSE(row.endings.empty()) << row.name;
    ASSERT_NE(row.looks_like, nullptr) << row.name;
    ASSERT_NE(row.read, nullptr) << row.name;
    for (const std::string_view ending : row.endings)
      EXPECT_TRUE(words.insert(std::string(ending)).second) << ending;
    EXPECT_TRUE(row.endings[0] == row.name || words.insert(row.name).second) << row.name;
    EXPECT_EQ(samples().count(row.name), 1u) << row.name;
  }
  EXPECT_EQ(ids.size(), std::size(model_formats()));
  // Every format of every kind has a row.
  for (const MeshFormat f :
       {MeshFormat::kStl, MeshFormat::kObj, MeshFormat::kPly, MeshFormat::kOff})
    EXPECT_STREQ(model_format(f).name, mesh_format_name(f));
  for (const SplineFormat f : {SplineFormat::kItd, SplineFormat::kG2, SplineFormat::kMfem,
                               SplineFormat::kGismo, SplineFormat::kJson})
    EXPECT_STREQ(model_format(f).name, spline_format_name(f));
  EXPECT_STREQ(model_format(MicroFormat::kMicro).name, "vmicro");
  EXPECT_STREQ(model_format(DmsFormat::kDms).name, "vdms");
}

TEST(ModelFormats, NamesAndEndingsAreFoundInAnyCase) {
  for (const ModelFormat& row : model_formats()) {
    EXPECT_EQ(format_from_name(upper(row.name)), &row);
    EXPECT_EQ(format_from_name(row.name, row.kind()), &row);
    for (const ModelKind kind :
         {ModelKind::kMesh, ModelKind::kSplines, ModelKind::kMicro, ModelKind::kDms})
      EXPECT_EQ(format_from_name(row.name, kind), kind == row.kind() ? &row : nullptr);
    for (const std::string_view ending : row.endings) {
      EXPECT_EQ(format_from_name(ending), &row);
      EXPECT_EQ(format_from_path("a/b.c/part." + upper(ending)), &row);
      EXPECT_EQ(format_from_path("a." + std::string(ending) + "/part"), nullptr);
    }
  }
  for (const char* const name : {"", "ply ", "step", ".obj"})
    EXPECT_EQ(format_from_name(name), nullptr) << name;
  for (const char* const path : {"", "obj", "part.off.gz", "part.", "part.obj/"})
    EXPECT_EQ(format_from_path(path), nullptr) << path;
  EXPECT_EQ(format_from_path(".obj"), &model_format(MeshFormat::kObj));
}

TEST(ModelFormats, ListsNameTheFormatsInTheirOrder) {
  EXPECT_EQ(format_names("or", ModelKind::kMesh), "stl, obj, ply or off");
  EXPECT_EQ(format_names("and"),
            "stl, obj, ply, off, itd, g2, mfem, gismo, vjson, vmicro and vdms");
}

TEST(ReadModel, TheOptionDecidesThenTheEndingThenTheContent) {
  for (const auto& [name, text] : samples()) {
    const ModelFormat& row = *format_from_name(name);
    EXPECT_EQ(format_name(read_as("model", text)), name);
    EXPECT_EQ(format_name(read_as("model.bin", text)), name);
    for (const std::string_view ending : row.endings)
      EXPECT_EQ(format_name(read_as("model." + upper(ending), text)), name);
    ModelReadOptions options;
    options.format = row.id;
    EXPECT_EQ(format_name(read_as("model", text, options)), name);
    EXPECT_EQ(format_name(read_as(name == "off" ? "x.obj" : "x.off", text, options)), name);
  }
  EXPECT_EQ(code_of(read_as("x.off", kObj)), "syntax");
}

TEST(ReadModel, TheAlternativeIsTheKindOfTheFormat) {
  for (const auto& [name, text] : samples()) {
    const auto file = read_as("x", text);
    ASSERT_TRUE(file) << message_of(file);
    EXPECT_EQ(kind_of(*file), format_from_name(name)->kind());
    EXPECT_EQ(num_bytes(*file), text.size());
    EXPECT_EQ(sha256_of(*file), to_hex(sha256(io_test::bytes(text))));
  }
}

TEST(ReadModel, WhatAFormatWritesItReadsBackTheSame) {
  std::size_t written = 0;
  for (const ModelFormat& row : model_formats()) {
    if (row.write == nullptr) continue;
    const auto file = read_as("x", samples().at(row.name));
    ASSERT_TRUE(file) << message_of(file);
    const Result<std::string> bytes = row.write(*file, {});
    ASSERT_TRUE(bytes) << row.name;
    const auto again = read_as("x." + std::string(row.name), *bytes);
    ASSERT_TRUE(again) << message_of(again);
    EXPECT_TRUE(same_model(*file, *again)) << row.name;
    ++written;
  }
  EXPECT_EQ(written, 9u);
}

TEST(ReadModel, TheHashIsThatOfTheBytesForAnyNumberOfJobs) {
  std::string text = samples().at("itd");
  while (text.size() < 1 << 17) text += "\n                                                       ";
  for (const int jobs : {1, 2, 8}) {
    ModelReadOptions options;
    options.jobs = jobs;
    const auto file = read_as("x.itd", text, options);
    ASSERT_TRUE(file) << message_of(file);
    EXPECT_EQ(sha256_of(*file), to_hex(sha256(io_test::bytes(text))));
  }
}

TEST(ReadModel, AFileOfAnotherKindIsRefusedByItsKind) {
  ModelReadOptions splines;
  splines.kind = ModelKind::kSplines;
  EXPECT_EQ(code_of(read_as("x.obj", kObj, splines)), "unknown-format");
  EXPECT_EQ(message_of(read_as("x.obj", kObj, splines)),
            "this is a mesh (obj); needed is a file of splines: itd, g2, mfem, gismo or vjson");
  EXPECT_EQ(message_of(read_as("x", kObj, splines)), message_of(read_as("x.obj", kObj, splines)));
  // The content counts if the ending is one of another kind.
  EXPECT_EQ(format_name(read_as("x.obj", samples().at("itd"), splines)), "itd");
  splines.format = MeshFormat::kStl;
  EXPECT_EQ(code_of(read_as("x.itd", samples().at("itd"), splines)), "bad-argument");
  EXPECT_EQ(message_of(read_as("x.itd", samples().at("itd"), splines)),
            "the format must be itd, g2, mfem, gismo or vjson, not stl");
  EXPECT_FALSE(read_mesh_bytes(io_test::bytes(samples().at("g2")), "x.g2", {}));
  EXPECT_TRUE(read_spline_bytes(io_test::bytes(samples().at("g2")), "x.g2", {}));
}

TEST(ReadModel, TheRefusalOfUnknownContentListsEveryFormat) {
  for (const std::string text : {"hello world", "   ", "<html>", "{\"a\": 1}"}) {
    const auto file = read_as("x.txt", text);
    EXPECT_EQ(code_of(file), "unknown-format") << text;
    EXPECT_EQ(message_of(file),
              "neither the ending of the name nor the content says whether this is stl, obj, ply, "
              "off, itd, g2, mfem, gismo, vjson, vmicro or vdms (--format)");
  }
}

// The first line of the start section: 72 columns of text, S, the number.
const std::string kIges = std::string("An exchange file").append(56, ' ') + "S      1\n";

struct Unread {
  const char* ending;
  std::string text;
  std::string name;
};

std::vector<Unread> unread_files() {
  return {
      {"step", "ISO-10303-21;\nHEADER;\n", "a STEP file"},
      {"stp", "\xEF\xBB\xBF\r\n ISO-10303-21;\nHEADER;\n", "a STEP file"},
      {"igs", kIges, "an IGES file"},
      {"brep", "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\n",
       "a BREP file of Open CASCADE"},
      {"brep", "\nCASCADE Topology V3, (c) Open Cascade\n", "a BREP file of Open CASCADE"},
      {"glb", "glTF\2\0\0\0\x40\0\0\0"s, "a glTF file"},
      {"gltf", "{\n \"meshes\": [],\n \"asset\": {\"version\": \"2.0\"}}", "a glTF file"},
      {"dae", "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"x\" version=\"1.4.1\">", "a COLLADA file"},
  };
}

TEST(ReadModel, FormatsThatAreNotReadYetAreNamed) {
  for (const Unread& f : unread_files())
    for (const std::string& name : {"x." + std::string(f.ending), "x"s}) {
      const auto file = read_as(name, f.text);
      EXPECT_EQ(code_of(file), "foreign-format") << f.name;
      EXPECT_EQ(message_of(file), "this is " + f.name +
                                      ": not read yet; the formats that are read are stl, obj, "
                                      "ply, off, itd, g2, mfem, gismo, vjson, vmicro and vdms");
    }
  const std::string package = "PK\3\4\x14\0\0\0....[Content_Types].xml...3D/3dmodel.model..."s;
  EXPECT_EQ(message_of(read_as("x.3mf", package)),
            "this is a 3MF file, a zip archive: not read yet");
}

TEST(ReadModel, ARefusalByAReaderNamesFormatsThatAreNotRead) {
  for (const Unread& f : unread_files()) {
    const auto file = read_as("x.off", f.text);
    EXPECT_EQ(code_of(file), "syntax") << f.name;
    EXPECT_NE(message_of(file).find("; it looks like " + f.name + ", which is not read yet"),
              std::string::npos)
        << message_of(file);
  }
}

TEST(ReadModel, ALookAtTheContentTakesNoFileAwayFromAReader) {
  // A line of OBJ that no reader knows is skipped; the header of a binary STL may hold anything.
  EXPECT_EQ(code_of(read_as("x.obj", "ISO-10303-21;\n" + kObj)), "ok");
  std::string stl = "ISO-10303-21; as a comment";
  stl.resize(80, ' ');
  stl += io_test::packed(1u, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f) + "\0\0"s;
  EXPECT_EQ(format_name(read_as("x", stl)), "stl");
  EXPECT_EQ(code_of(read_as("x", kIges + kObj)), "foreign-format");
  EXPECT_EQ(format_name(read_as("x", "# " + kIges + kObj)), "obj");
}

TEST(ReadModel, PackedDataIsNamedWhateverTheFormatAskedFor) {
  const std::pair<std::string, const char*> cases[] = {
      {"\x1F\x8B\x08..."s, "this is gzip data, not a model"},
      {"PK\3\4....", "this is a zip archive, not a model"},
      {"\xFF\xFEv\0 \0"s, "this is UTF-16 text, not a model"}};
  for (const auto& [text, message] : cases)
    for (const ModelFormat& row : model_formats()) {
      ModelReadOptions options;
      options.format = row.id;
      EXPECT_EQ(code_of(read_as("x", text, options)), "foreign-format");
      EXPECT_EQ(message_of(read_as("x", text, options)), message);
      EXPECT_EQ(code_of(read_as("x", "", options)), "empty");
    }
}

TEST(ReadModel, EveryErrorHasItsCode) {
  const TempFolder folder;
  EXPECT_EQ(code_of(read_model_file(folder / "none.obj", {})), "cannot-open");
  EXPECT_EQ(code_of(read_model_file(folder / "", {})), "cannot-open");
  EXPECT_EQ(code_of(read_model_file(folder.write("a.obj", ""), {})), "empty");
  EXPECT_EQ(code_of(read_model_file(folder.write("b.obj", kObj), {})), "ok");
  EXPECT_EQ(code_of(read_model_file("-", {})), "bad-argument");
  ModelReadOptions options;
  options.jobs = 0;
  EXPECT_EQ(code_of(read_as("x.obj", kObj, options)), "bad-argument");
  options.jobs = 1;
  options.limits.max_bytes = kObj.size() - 1;
  EXPECT_EQ(code_of(read_as("x.obj", kObj, options)), "over-limit");
  EXPECT_EQ(code_of(read_model_file(folder / "b.obj", options)), "over-limit");
  EXPECT_EQ(code_of(read_as("x.obj", "v 0 zero 0\n")), "syntax");
  EXPECT_EQ(code_of(read_as("x.stl", "solid\nfacet")), "truncated");
  EXPECT_EQ(code_of(read_as("x.obj", "v 0 0 1e999\n")), "not-finite");
  EXPECT_EQ(code_of(read_as("x.obj", kObj + "f 1 2 4\n")), "index-out-of-range");
  EXPECT_EQ(code_of(read_as("x.itd", "[CURVE BSPLINE 2 2 E1 [KV 3 2 1 0] [0] [1]]")), "bad-spline");
  EXPECT_EQ(code_of(read_as("x", "hello")), "unknown-format");
  EXPECT_EQ(code_of(read_as("x", "BZh91AY")), "foreign-format");
}

TEST(ReadModel, BytesThatWereLoadedOnceAreReadAgainUnderOtherLimits) {
  const TempFolder folder;
  const std::string path = folder.write("a.itd", "[CURVE BEZIER 2 E1 [0] [1.234]]");
  ModelReadOptions options;
  const Result<ModelBytes> bytes = load_model(path, options);
  ASSERT_TRUE(bytes);
  std::filesystem::remove(path);
  EXPECT_EQ(format_name(read_model(*bytes, options)), "itd");
  EXPECT_EQ(choose_format(*bytes, options).value(), FormatId(SplineFormat::kItd));
  options.limits.max_digits = 3;
  EXPECT_EQ(code_of(read_model(*bytes, options)), "over-limit");
}

// Under wider limits, the file names the number that the default limits would have stopped at.
TEST(ReadModel, TheFirstNumberBeyondTheDefaultLimitsIsKept) {
  const std::string numbers[] = {"1e5000", "1" + std::string(1000, '0'),
                                 "0." + std::string(1200, '3')};
  for (const std::string& number : numbers) {
    const std::string text = "[CURVE BEZIER 3 E1 [0]\n[" + number + "] [1e6000]]";
    const auto narrow = read_as("x.itd", text);
    EXPECT_EQ(code_of(narrow), "over-limit");
    ModelReadOptions wide;
    wide.limits.max_digits = 5000;
    wide.limits.max_exponent = 9000;
    const auto file = read_as("x.itd", text, wide);
    ASSERT_TRUE(file) << message_of(file);
    const auto& kept = std::get<SplineFile>(*file).beyond_default_limits;
    ASSERT_TRUE(kept);
    EXPECT_EQ(to_string(*kept), to_string(narrow.error()));
    EXPECT_EQ(kept->place.line, 2u);
  }
  ModelReadOptions wide;
  wide.limits.max_digits = 5000;
  const auto file = read_as("x.itd", "[CURVE BEZIER 2 E1 [0] [1.5]]", wide);
  ASSERT_TRUE(file);
  EXPECT_FALSE(std::get<SplineFile>(*file).beyond_default_limits);
  // JSON: integers and fractions may have as many digits as a decimal within the limits has when it is written out.
  std::string json = samples().at("vjson");
  const std::size_t at = json.find("\"0\"");
  ASSERT_NE(at, json.npos);
  json.replace(at, 3, "\"1/" + std::string(5200, '7') + "\"");
  const auto narrow = read_as("x.vjson", json);
  EXPECT_EQ(code_of(narrow), "over-limit") << message_of(narrow);
  const auto broad = read_as("x.vjson", json, wide);
  ASSERT_TRUE(broad) << message_of(broad);
  ASSERT_TRUE(std::get<SplineFile>(*broad).beyond_default_limits);
  EXPECT_EQ(to_string(*std::get<SplineFile>(*broad).beyond_default_limits),
            to_string(narrow.error()));
}

}  // namespace
}  // namespace veritope
