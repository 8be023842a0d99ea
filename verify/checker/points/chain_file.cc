// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "chain_file.h"

#include "../patches/json_reader.h"

namespace {

bool is_name_start(char c) { return c == '_' || ((c | 32) >= 'a' && (c | 32) <= 'z'); }
bool is_name_part(char c) { return is_name_start(c) || (c >= '0' && c <= '9'); }
bool is_name(const std::string& s) {
  return !s.empty() && is_name_start(s[0]) && std::all_of(s.begin(), s.end(), is_name_part);
}

// Operators wait on a stack until one follows that does not come first.
class ExpressionReader {
 public:
  explicit ExpressionReader(const std::string& text) : text_(text) {}

  std::vector<ExpressionNode> nodes;
  std::vector<std::string> names;  // in the order of their first occurrence

  void read() {
    for (skip(); at_ < text_.size(); skip()) needs_operand_ ? operand() : connective();
    expect(!needs_operand_, "the expression ends too early");
    while (!waiting_.empty()) {
      expect(waiting_.back() != '(', "a parenthesis of the expression is not closed");
      reduce();
    }
  }

 private:
  void skip() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }
  // No operator reaches beyond '('.
  static int strength(char op) { return op == '!' ? 3 : op == '&' ? 2 : op == '(' ? 0 : 1; }

  void operand() {
    const char c = text_[at_];
    if (c == '(' || c == '!') {
      waiting_ += text_[at_++];
      return;
    }
    expect(is_name_start(c), "the expression lacks an operand");
    std::string name;
    while (at_ < text_.size() && is_name_part(text_[at_])) name += text_[at_++];
    const uint32_t number = numbers_.emplace(name, uint32_t(names.size())).first->second;
    if (number == names.size()) names.push_back(name);
    expect(++num_leaves_ <= kMostLeaves, "the expression has more than 10000 operands");
    add(ExpressionNode{ExpressionNode::kLeaf, number, 0});
    needs_operand_ = false;
  }
  void connective() {
    const char c = text_[at_++];
    expect(c != '\0' && std::string(")&|+-").find(c) != text_.npos,
           "the expression lacks an operator");
    while (!waiting_.empty() && strength(waiting_.back()) >= (c == ')' ? 1 : strength(c))) reduce();
    if (c != ')') {
      waiting_ += c;
      needs_operand_ = true;
      return;
    }
    expect(!waiting_.empty(), "a parenthesis of the expression was not opened");
    waiting_.pop_back();
  }
  void reduce() {
    expect(++num_operators_ <= kMostOperators, "the expression has more than 100000 operators");
    const char op = waiting_.back();
    waiting_.pop_back();
    const uint32_t last = values_.back();
    values_.pop_back();
    if (op == '!') return add(ExpressionNode{ExpressionNode::kComplement, last, 0});
    const uint32_t first = values_.back();
    values_.pop_back();
    add(ExpressionNode{op == '&'   ? ExpressionNode::kIntersection
                       : op == '-' ? ExpressionNode::kDifference
                                   : ExpressionNode::kUnion,
                       first, last});
  }
  void add(const ExpressionNode& node) {
    values_.push_back(uint32_t(nodes.size()));
    nodes.push_back(node);
  }

  const std::string& text_;
  size_t at_ = 0;
  bool needs_operand_ = true;
  uint64_t num_leaves_ = 0, num_operators_ = 0;
  std::map<std::string, uint32_t> numbers_;
  std::string waiting_;
  std::vector<uint32_t> values_;
};

const char* const kFormats[] = {"stl", "obj", "ply", "off", "vjson", "itd", "g2", "mfem", "chain"};

struct ChainReader : JsonReader {
  using JsonReader::JsonReader;

  ChainOperand operand() {
    ChainOperand o;
    object({"name", "path", "sha256", "format"}, [&](size_t key) {
      (key == 0 ? o.name : key == 1 ? o.path : key == 2 ? o.hash : o.format) = string();
    });
    expect(is_name(o.name), "an operand has no name");
    expect(!o.path.empty() && o.path.find('\0') == o.path.npos, "an operand has no path");
    expect(o.hash.size() == 64 && o.hash.find_first_not_of("0123456789abcdef") == o.hash.npos,
           "an operand has no sha256");
    expect(std::find(std::begin(kFormats), std::end(kFormats), o.format) != std::end(kFormats),
           "an operand has an unknown format");
    return o;
  }
  Bounds3 box() {
    std::vector<Ratio> bounds;
    list([&] { bounds.push_back(read_number(string())); });
    expect(bounds.size() == 6, "the box does not have six bounds");
    Bounds3 r;
    for (size_t k = 0; k < 3; ++k) {
      expect(compare(bounds[k], bounds[k + 3]) < 0, "the box has no interior");
      r.lo[k] = bounds[k], r.hi[k] = bounds[k + 3];
    }
    return r;
  }
  ChainFile file() {
    ChainFile r;
    std::map<std::string, ChainOperand> operands;
    std::string expression;
    object({"schema", "tool", "expression", "operands", "box", "boundary"}, [&](size_t key) {
      if (key == 0) expect(string() == "veritope-chain-1", "unknown schema");
      if (key == 1) string();
      if (key == 2) expression = string();
      if (key == 3)
        list([&] {
          const ChainOperand o = operand();
          expect(operands.emplace(o.name, o).second, "two operands have one name");
        });
      if (key == 4) r.box = box();
      if (key == 5) expect(string() == "not certified", "unknown boundary");
    });
    expect(next() == '\0' && at == text.size(), "something follows the expression");
    ExpressionReader reader(expression);
    reader.read();
    expect(operands.size() == reader.names.size(), "an operand is not in the expression");
    for (const std::string& name : reader.names) {
      expect(operands.count(name) != 0, "the expression names no operand");
      r.operands.push_back(operands[name]);
    }
    r.nodes.swap(reader.nodes);
    return r;
  }
};

}  // namespace

ChainFile read_chain_file(const std::string& text) {
  size_t at = text.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0;
  return ChainReader(text, &at).file();
}
