// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/reason_explanations.h"

#include <algorithm>
#include <array>

namespace veritope::cli {
namespace {

constexpr auto kReasons = std::to_array<ReasonText>({
    {"undecided", "verdict UNDECIDED",
     "The file was read, but there is no verdict: neither VALID nor INVALID was proved and "
     "confirmed. It does not mean "
     "\"probably valid\". Status 3, or 5 if the cause is a bug of ours; the code and the message "
     "of the report name the reason.",
     "A proof that was not found (not-certified), a file outside of what certificates speak about "
     "(not-covered), too "
     "little memory or work allowed, a checker that could not be started.",
     "Look up the code that stands beside the verdict, for instance: veritope explain "
     "not-certified"},
    {"unreadable", "verdict UNREADABLE",
     "The file could not be read as a model, so that the question of a verdict does not arise. "
     "Nothing was repaired or "
     "guessed. Status 4; the code and the message name the first place that cannot be read.",
     "A damaged or incomplete download, another format under this name, a number such as nan, an "
     "index that names no "
     "vertex, a limit that is exceeded.",
     "Look up the code that stands beside the verdict; --format names the format of a file whose "
     "name says something else."},

    {"cannot-open", "file that cannot be opened",
     "The file does not exist, is a folder, or may not be read. Status 4.",
     "A misspelt path, missing permissions, a folder in the place of a file.",
     "Check the path and the permissions. Standard input is named - and needs --format."},
    {"empty", "nothing to decide about",
     "The input has no bytes, or no triangle, or no surface. An empty model is not called valid. "
     "Status 4.",
     "An interrupted export, a file of points, lines or curves only.",
     "Export the surface again; veritope info lists what a file holds."},
    {"foreign-format", "content of another kind",
     "The bytes are recognisably something else: a compressed file, UTF-16 text, a web page, a "
     "git-lfs pointer, or a "
     "variant of the format that is not supported. Status 4.",
     "A file that was not unpacked, a pointer in the place of a large file, a page with an error "
     "message saved as a model.",
     "Unpack or fetch the file itself; the message says what was recognised."},
    {"unknown-format", "format that is not known",
     "Neither the name nor the content says which reader applies. Status 4.",
     "An ending that is not known, or standard input without a format.",
     "Say which format it is with --format."},
    {"syntax", "text that the format does not allow",
     "A token, a keyword or a header line stands where the format does not allow it. Status 4; the "
     "message says what was "
     "expected and the line or byte where it is missing.",
     "A file that was edited by hand, a dialect of the format, a decimal comma.",
     "Correct the place that is named, or export again."},
    {"truncated", "file that ends too early",
     "The data end before what the header or the grammar announces. Status 4.",
     "An interrupted download or export, a count in the header that is too large.",
     "Fetch or export the file again."},
    {"not-finite", "number that is not finite",
     "A coordinate is NaN or infinite, or rounds to infinity as binary64. Such a number is no "
     "place in space. Status 4.",
     "A division by zero in the program that wrote the file, an exponent that is too large.",
     "Correct the number at the place that is named."},
    {"index-out-of-range", "index that names no vertex",
     "A face names a vertex that the file does not have. Status 4.",
     "Indices from 0 in a format that counts from 1 or the reverse, vertices that were deleted.",
     "Export again, or correct the index at the place that is named."},
    {"over-limit", "limit that is exceeded",
     "The file is larger than a limit allows: bytes, faces, digits or the exponent of a number. "
     "Limits protect from files "
     "that would fill the memory. Status 4; the message names the option.",
     "A large model, or a damaged count.",
     "Raise the limit with the option that the message names, for instance --max-bytes."},
    {"lossy", "conversion that would lose something",
     "The output format cannot hold the model as it is, and nothing may be lost unasked: convert "
     "writes no file. Status 1.",
     "Doubles into a binary STL, knots or rational numbers that binary64 does not hold, shapes "
     "that the format lacks.",
     "Choose another format, or permit the loss with the option that the message names."},
    {"cannot-write", "output that cannot be written",
     "An output or a temporary file could not be written; nothing incomplete was left behind. "
     "Status 4, unless another file "
     "of the same run asks for 5 or 1.",
     "A full disk, a folder that does not exist, missing permissions.",
     "Check the folder, its permissions and its free space; TMPDIR says where temporary files go."},
    {"interrupted", "run that was interrupted",
     "The user or the system stopped the run. What is said about the file is not complete.",
     "Ctrl-C, a time limit of the system.", "Run it again."},
    {"bad-argument", "argument outside of its range",
     "An option or a parameter is outside of its documented range. Nothing was computed. Status 2.",
     "A misspelt value, an option that this kind of file does not have.",
     "veritope COMMAND --help lists the values."},
    {"bad-spline", "data that are no spline",
     "Knots, a degree, a weight or a number of control points that no spline has. Status 4; the "
     "message names the entity.",
     "Knots out of order, more or fewer control points than degree and knots ask for, a weight "
     "that is not positive.",
     "Export again, or correct the entity that is named."},
    {"bad-environment", "floating point that computes otherwise",
     "This process does not compute as IEEE 754 and its default settings ask for: another rounding "
     "mode, subnormal numbers "
     "flushed to zero, excess precision. Library calls that need it refuse; predicates decide by "
     "integers instead.",
     "-ffast-math in a program that uses the library, a plug-in that changed the control word.",
     "Restore the settings before the call; the message names what differs."},

    {"not-covered", "model that certificates do not speak about",
     "The file was read, but no certificate can be about it: a shape in it was not read, numbers "
     "are longer than checkers accept, a volume folds or has a degree over 15, or entities are "
     "neither patches in space nor volumes alone. Nothing is said about its validity. Status 3.",
     "Trimmed surfaces, curves or volumes beside surfaces, patches of the plane, volumes whose "
     "faces have no area or are left out as walls.",
     "The message says what is not covered. Export trimmed faces untrimmed, or as a mesh; veritope "
     "convert --faces writes the faces of volumes alone."},
    {"not-inside", "microstructure not proved to be inside",
     "With --model M: the microstructure was proved to be a solid, but not to lie in the "
     "interior of M. The message names the condition of the certificate's page (I1 to I4), the "
     "place and the triangle of M. It may lie there, or not. Status 3.",
     "A tile or a bridge that crosses or touches M or comes very near it, another model than "
     "the one it was made for, a void of M in a tile, a void off the cage.",
     "Make it again by veritope micro --model M, which keeps tiles that are proved to lie in "
     "M; look at the place."},
    {"model-invalid", "model that bounds no solid",
     "With --model M: M is not proved to bound a solid, so that nothing can be said to lie in "
     "its interior. Status 3.",
     "A mesh that is open, crosses itself, or faces the wrong way.",
     "veritope certify M says what is wrong with it; --orient auto and export settings may "
     "repair it."},
    {"no-collar", "no octree collar found",
     "The model is decided, and --collar found no cells around the surface that form a collar. The "
     "verdict and its "
     "certificate stand without one.",
     "Sheets or edges nearer to each other than the smallest cells allowed, a model far from the "
     "origin or so flat that "
     "octrees, which are cubes, would need too many cells.",
     "The message names the place and what was tried; bring the model near to the origin, or do "
     "without --collar."},
    {"memory-limit", "limit of memory reached",
     "The search for a proof, or for a collar, would have needed more memory than it may take, and "
     "ended before it took it. The message says what was reached. Status 3 without a verdict; a "
     "verdict that was proved before stands, with its certificate.",
     "Very many patches, sheets very near each other, edges at acute angles, cells around walls "
     "that are thin for the size of the model.",
     "Raise --max-memory, which counts MiB and is half of the machine's memory unless it is given; "
     "cut the model into parts; do without --collar."},
    {"cell-limit", "limit of boxes or cells reached",
     "The search tried as many boxes, or made as many octree cells, as it may. The message says "
     "what was reached. Status 3 without a verdict; a verdict that was proved before stands, with "
     "its certificate.",
     "Sheets very near each other, edges at acute angles, cells around walls that are thin for the "
     "size of the model.",
     "Raise --max-cells, and --max-memory with it; widen the gap that the message names; do "
     "without --collar."},
    {"data-after-end", "bytes after the declared end",
     "A notice, not an error: the counts of the file end before its bytes do. The file is read as "
     "its counts say, which is "
     "what the certificate speaks about.",
     "A count that was not updated when facets were added, two files joined into one, an exporter "
     "that appends data of its own.",
     "If the message says that the rest is a whole number of facets, the count is probably wrong: "
     "export the file again, or "
     "correct the count."},
    {"over-budget", "proof that is too long",
     "A proof was found, but checking it takes more work or memory than every checker of this "
     "certificate may spend. "
     "Status 3.",
     "Very many faces or patches near each other, long numbers together with high degrees.",
     "Simplify the model or cut it into parts."},
    {"out-of-memory", "not enough memory",
     "This program or the checker ran out of memory, or the system ended the checker with SIGKILL, "
     "which it does when "
     "memory is short. Status 3.",
     "A large model, or other programs beside it.", "Free memory, or use a larger machine."},
    {"not-checked", "checker that could not be started",
     "The proof was found, but veritope-check could not be started, so that nobody else confirmed "
     "it: no verdict. Status 3.",
     "An incomplete installation, VERITOPE_CHECK that names another file.",
     "Install veritope-check beside veritope, or set VERITOPE_CHECK. --no-check asks for an answer "
     "that is not checked."},
    {"file-changed", "file that changed meanwhile",
     "The bytes that the checker read are not those that were certified. What was found is about "
     "bytes that are gone, and "
     "is not reported. Status 4.",
     "A program that still writes the file.", "Run it again when the file is complete."},
    {"internal", "bug of ours",
     "A check inside of the program failed, or the checker rejected a certificate that we made. "
     "There is no verdict, and "
     "no wrong one. Status 5.",
     "An error in our code, or memory that is damaged.",
     "Please report it with the file; the message says how to reproduce it."},

    {"tet-reversed", "tetrahedron that is reversed or flat",
     "The four vertices of a tetrahedron of a simplex-spline solid's domain have a determinant "
     "that is zero or negative. veritope dms refuses the model. Status 1.",
     "Vertices in the other order, a mirrored domain, four vertices on one plane.",
     "Exchange two vertices of the tetrahedron, in its control points, too, if they are separate; "
     "remove flat ones."},
    {"tet-face-overused", "triangle that too many tetrahedra share",
     "Three vertices of a simplex-spline solid's domain are a face of three tetrahedra or more, or "
     "of two that lie on one side of it. veritope dms refuses the model. Status 1.",
     "A tetrahedron that occurs twice, a reversed one beside others, tetrahedra that overlap.",
     "Remove or reverse one of the tetrahedra that the message names."},
    {"cloud-degenerate", "knots whose tetrahedron is reversed or flat",
     "Four knots of a tetrahedron's vertices, the last ones of the beta that the message names, "
     "have a determinant that is zero or negative: condition (a) of docs/formats/dms-files.md. "
     "veritope dms refuses the model. Status 1.",
     "Clouds that are too large for the tetrahedra at their vertices.",
     "Move the knots closer to their vertices; veritope dms make --clouds draws clouds that are "
     "small enough."},
    {"cloud-no-core", "knots' tetrahedra without a common inner point",
     "The tetrahedra of the knots of one tetrahedron's vertices have no common inner point: "
     "condition (b) of docs/formats/dms-files.md. The message names at most four of them that have "
     "none. veritope dms refuses the model. Status 1.",
     "Clouds that are too large for the tetrahedra at their vertices, two of which reach past each "
     "other.",
     "Move the knots closer to their vertices; veritope dms make --clouds draws clouds that are "
     "small enough."},
    {"cloud-inside", "knots of outer faces that reach inward",
     "The convex hull of knots of a face of the domain's boundary contains an inner point of a "
     "tetrahedron: condition (c) of docs/formats/dms-files.md. Then the basis functions do not add "
     "up to 1 there. veritope dms refuses the model. Status 1.",
     "Knots of a vertex of the boundary on the inner side of one of its faces; at a saddle there is "
     "no place on the outer side of all faces but in their planes.",
     "Move the knots outward, or into the planes of the faces; collapse the cloud."},
    {"domains-differ", "attributes over another domain than the geometry's",
     "The boundary of an attribute domain and that of the geometry's domain are not the same set of "
     "points: the point that the message names is on one of them only. veritope dms refuses the "
     "model; for certify it is not-covered. Status 1, and 3 for certify.",
     "An attribute domain that was made for another solid, or whose boundary was rounded; a vertex "
     "of one boundary that was moved.",
     "Move the vertices of the boundaries onto each other. Faces may be cut in different ways, but "
     "exactly in the same planes."},
    {"jacobian", "map that folds a simplex-spline solid",
     "The determinant of the derivative of a simplex-spline solid's map is below 0 at the point of "
     "the domain that is named, or 0 everywhere near it: the map is not one to one onto a solid. "
     "Status 1.",
     "Control points that were moved past others, a mirrored solid, a part that is flat.",
     "Move the control points of the tetrahedron that is named back; mirror the solid again."},

    {"narrow", "critical points too close together",
     "veritope project: a box of parameters became as narrow as 2^-80 and may still hold one "
     "critical point or several. "
     "Status 3.",
     "A multiple critical point, a point at a centre of curvature, a knot where the second "
     "derivative jumps.",
     "Move the point; or use the other answers, which are proved all the same."},
    {"precision", "not enough precision",
     "veritope project: the enclosures did not become tight enough at the highest precision that "
     "is tried. Status 3.",
     "A knot where the second derivative jumps, weights of very different size.",
     "Move the point or scale the model."},
    {"budget", "not enough boxes allowed",
     "veritope project: the number of boxes that may be looked at was spent. Status 3.",
     "Many critical points, or curves of them.", "Raise --max-boxes."},
    {"zero-equation", "all points at the same distance",
     "veritope project: the equation of critical points is zero everywhere on this part: all of "
     "its points are equally far "
     "from the given one, so that none is isolated. Status 3.",
     "The centre of a circle or a sphere, a point on the axis of a surface of revolution.",
     "Nothing: the distance of any point of the part is the answer."},
});

char lower(char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

std::span<const ReasonText> reason_texts() { return kReasons; }

const ReasonText* reason_text(std::string_view code) {
  const auto at = std::find_if(kReasons.begin(), kReasons.end(), [&](const ReasonText& r) {
    return std::equal(r.code.begin(), r.code.end(), code.begin(), code.end(),
                      [](char a, char b) { return a == lower(b); });
  });
  return at == kReasons.end() ? nullptr : &*at;
}

}  // namespace veritope::cli
