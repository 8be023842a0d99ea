// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/chain_text_fuzz.cc: any bytes as an expression and as a chain file. What is read, is written, and reads back as
// the same; errors of expressions name a column of the text; the normal form and its decision diagram are one function.
#include <cstdint>
#include <string>
#include <string_view>

#include "io/chains/chain_file.h"
#include "robust/base/check.h"
#include "solids/expression/decision_diagram.h"

namespace {

using namespace veritope;

Formula normal_form(const ExpressionText& text) {
  std::vector<Formula> operands;
  for (std::uint32_t i = 0; i < text.operands.size(); ++i) operands.push_back(Formula::variable(i));
  return text.tree.formula(operands,
                           Formula::variable(static_cast<std::uint32_t>(operands.size())));
}

void check_function(const Formula& f) {
  const auto diagram = DecisionDiagram::make(f, 2000);
  if (!diagram) return;
  for (std::uint32_t pattern = 0; pattern < 64; ++pattern) {
    const auto bit_of = [&](std::uint32_t v) {
      return ((pattern * 2654435761u) >> (v % 32) & 1u) != 0;
    };
    const Value3 value = f.value([&](std::uint32_t v) { return to_value(bit_of(v)); });
    VT_CHECK(is_constant(value), "all variables have values");
    VT_CHECK(diagram->value(bit_of) == (value == Value3::kOne), "the diagram is another function");
  }
}

void check_column(const Error& error, std::size_t size) {
  constexpr std::string_view kColumn = "column ";
  if (error.code == Code::kOverLimit) return;
  VT_CHECK(error.code == Code::kSyntax && error.message.starts_with(kColumn), "no column");
  const unsigned long column = std::stoul(error.message.substr(kColumn.size()));
  VT_CHECK(column >= 1 && column <= size + 1, "a column off the text");
}

void check_expression(std::string_view text) {
  const Result<ExpressionText> read = read_expression(text);
  if (!read) return check_column(read.error(), text.size());
  std::vector<std::string> names;
  std::vector<ExpressionSize> sizes;
  for (const OperandName& o : read->operands) {
    VT_CHECK(o.is_file || is_operand_name(o.text), "an operand without a name");
    VT_CHECK(o.column >= 1 && o.column <= text.size(), "an operand off the text");
    names.push_back(o.is_file ? '"' + o.text + '"' : o.text);
    sizes.emplace_back();
  }
  if (!read->tree.size(sizes).is_allowed()) return;
  const std::string written = write_expression(read->tree, names);
  const Result<ExpressionText> again = read_expression(written);
  VT_CHECK(again.has_value() && again->operands == read->operands, "the text does not read back");
  const Formula f = normal_form(*read);
  VT_CHECK(normal_form(*again) == f, "another expression reads back");
  VT_CHECK(f.negated().negated() == f, "a double negation is another formula");
  if (f.num_literals() <= 200) check_function(f);
}

void check_chain(const std::uint8_t* data, std::size_t size) {
  const std::string name = "chain.json";
  const ByteBuffer buffer = copy_to_buffer({data, size});
  const Result<ChainFile> read = read_chain(source_of(buffer, name), {});
  if (!read) return VT_CHECK(read.error().place.line.has_value(), "an error without a line");
  std::vector<ExpressionSize> sizes(read->operands.size());
  if (!read->tree.size(sizes).is_allowed()) return;
  const std::string written = write_chain(*read);
  const ByteBuffer bytes =
      copy_to_buffer({reinterpret_cast<const unsigned char*>(written.data()), written.size()});
  VT_CHECK(looks_like_chain(source_of(bytes, name)), "a chain file is not recognised");
  const Result<ChainFile> again = read_chain(source_of(bytes, name), {});
  VT_CHECK(again.has_value() && write_chain(*again) == written, "the file does not read back");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  check_expression({reinterpret_cast<const char*>(data), size});
  check_chain(data, size);
  return 0;
}
