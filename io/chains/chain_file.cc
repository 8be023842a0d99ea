// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/chains/chain_file.h"

#include <algorithm>
#include <utility>

#include "io/base/json_string.h"
#include "io/splines/spline_json_lexer.h"

namespace veritope {
namespace {

constexpr std::string_view kChainSchema = "veritope-chain-1";
constexpr std::string_view kNotCertified = "not certified";

bool is_sha256(std::string_view text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == text.npos;
}

class ChainReader : SplineJsonLexer {
 public:
  using SplineJsonLexer::SplineJsonLexer;
  using SplineTextReader::take_error;

  bool read() {
    const bool is_read = read_object(
        {"schema", "tool", "expression", "operands", "box", "boundary"}, [&](std::size_t key) {
          switch (key) {
            case 0: return read_word("schema", kChainSchema);
            case 1: return read_string(out_.tool);
            case 2: return read_tree();
            case 3: return read_list([&] { return read_operand(); });
            case 4: return read_box();
            default: return read_word("boundary", kNotCertified);
          }
        });
    if (!is_read) return false;
    if (!is_at_end()) return fail_expected("the end of the file");
    return match();
  }
  ChainFile take() { return std::move(out_); }

 private:
  bool read_word(std::string_view key, std::string_view word) {
    skip();
    const char* const at = p_;
    std::string text;
    if (!read_string(text)) return false;
    if (text == word) return true;
    return fail(at, Code::kSyntax,
                "the " + std::string(key) + " must be " + quoted(word) + ", not " + quoted(text));
  }

  bool read_tree() {
    skip();
    expression_at_ = p_;
    std::string text;
    if (!read_string(text)) return false;
    Result<ExpressionText> read = read_expression(text);
    if (!read)
      return fail(expression_at_, read.error().code, "the expression: " + read.error().message);
    expression_ = std::move(*read);
    return true;
  }

  bool read_operand() {
    skip();
    const char* const at = p_;
    ChainOperand o;
    if (!read_object({"name", "path", "sha256", "format"}, [&](std::size_t key) {
          return read_string(key == 0   ? o.name
                             : key == 1 ? o.path
                             : key == 2 ? o.sha256
                                        : o.format);
        }))
      return false;
    if (!is_operand_name(o.name))
      return fail(at, Code::kSyntax,
                  "an operand's name has letters, digits and _, and does not begin with a digit: " +
                      quoted(o.name));
    if (!is_sha256(o.sha256))
      return fail(at, Code::kSyntax, "a sha256 has 64 digits 0-9, a-f: " + quoted(o.sha256));
    if (o.path.empty() || o.path.find('\0') != o.path.npos)
      return fail(at, Code::kSyntax, "the path of the operand " + o.name + " names no file");
    for (const ChainOperand& other : operands_)
      if (other.name == o.name)
        return fail(at, Code::kSyntax, "two operands have the name " + o.name);
    if (operands_.size() == kMostLeaves)
      return fail(at, Code::kOverLimit, "more than " + std::to_string(kMostLeaves) + " operands");
    operands_.push_back(std::move(o));
    operands_at_.push_back(at);
    return true;
  }

  bool read_box() {
    skip();
    const char* const at = p_;
    std::vector<Rational> bounds;
    if (!read_list([&] { return read_exact(bounds.emplace_back()); })) return false;
    if (bounds.size() != 6)
      return fail(at, Code::kSyntax,
                  "a box has six bounds, but there are " + std::to_string(bounds.size()));
    for (std::size_t k = 0; k < 3; ++k) {
      if (bounds[k + 3] <= bounds[k])
        return fail(at, Code::kSyntax,
                    "the box has no interior: its bounds are x0, y0, z0, x1, y1, z1");
      out_.box[k] = {std::move(bounds[k]), std::move(bounds[k + 3])};
    }
    return true;
  }

  // Operands take the order of the expression's numbers.
  bool match() {
    std::vector<bool> is_used(operands_.size());
    for (const OperandName& name : expression_.operands) {
      if (name.is_file)
        return fail(expression_at_, Code::kSyntax,
                    "the expression: column " + std::to_string(name.column) +
                        ": operands of chain files have names, not " + quoted(name.text));
      const auto found = std::find_if(operands_.begin(), operands_.end(),
                                      [&](const ChainOperand& o) { return o.name == name.text; });
      if (found == operands_.end())
        return fail(expression_at_, Code::kSyntax,
                    "the expression: column " + std::to_string(name.column) +
                        ": no operand has the name " + name.text);
      is_used[static_cast<std::size_t>(found - operands_.begin())] = true;
      out_.operands.push_back(*found);
    }
    for (std::size_t i = 0; i < is_used.size(); ++i)
      if (!is_used[i])
        return fail(operands_at_[i], Code::kSyntax,
                    "the expression does not name the operand " + operands_[i].name);
    out_.tree = std::move(expression_.tree);
    return true;
  }

  ChainFile out_;
  ExpressionText expression_;
  const char* expression_at_ = nullptr;
  std::vector<ChainOperand> operands_;  // in the order of the file
  std::vector<const char*> operands_at_;
};

void append_string(std::string_view s, std::string& out) { append_json_string(to_utf8(s), out); }

}  // namespace

bool looks_like_chain(const Source& source) {
  const char* const begin = skip_space(skip_byte_order_mark(source), source.end);
  if (begin == source.end || *begin != '{') return false;
  const std::string_view text(
      begin, std::min<std::size_t>(kMostChainStart, static_cast<std::size_t>(source.end - begin)));
  constexpr std::string_view kKey = "\"schema\"";
  std::size_t at = text.find(kKey);
  if (at == text.npos) return false;
  at = text.find_first_not_of(" \t\r\n", at + kKey.size());
  if (at == text.npos || text[at] != ':') return false;
  at = text.find_first_not_of(" \t\r\n", at + 1);
  return at != text.npos && text.substr(at).starts_with("\"veritope-chain-");
}

Result<ChainFile> read_chain(const Source& source, const ReadLimits& limits) {
  ChainReader reader(source, limits);
  if (!reader.read()) return reader.take_error();
  return reader.take();
}

std::string write_chain(const ChainFile& chain) {
  std::string out = "{\"schema\": ";
  append_string(kChainSchema, out);
  out += ",\n\"tool\": ";
  append_string(chain.tool, out);
  out += ",\n\"expression\": ";
  std::vector<std::string> names;
  for (const ChainOperand& o : chain.operands) names.push_back(o.name);
  append_string(write_expression(chain.tree, names), out);
  out += ",\n\"operands\": [";
  for (std::size_t i = 0; i < chain.operands.size(); ++i) {
    const ChainOperand& o = chain.operands[i];
    out += i == 0 ? "\n {\"name\": " : ",\n {\"name\": ";
    append_string(o.name, out);
    out += ", \"path\": ";
    append_string(o.path, out);
    out += ", \"sha256\": ";
    append_string(o.sha256, out);
    out += ", \"format\": ";
    append_string(o.format, out);
    out += "}";
  }
  out += "],\n\"box\": [";
  for (std::size_t i = 0; i < 6; ++i) {
    if (i > 0) out += ", ";
    append_string((i < 3 ? chain.box[i].lo : chain.box[i - 3].hi).to_string(), out);
  }
  out += "],\n\"boundary\": ";
  append_string(kNotCertified, out);
  return out + "}\n";
}

}  // namespace veritope
