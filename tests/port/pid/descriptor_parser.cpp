// SPDX-License-Identifier: MIT

#include "descriptor_parser.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace batuta::pid::test {
namespace {

struct Item {
  int type = 0;  ///< 0 main, 1 global, 2 local
  int tag = 0;
  int size = 0;
  std::uint32_t raw = 0;

  std::int64_t with_sign() const {
    if (size == 0 || size == 4) return static_cast<std::int32_t>(raw);
    const std::int64_t half = std::int64_t{1} << (8 * size - 1);
    return raw >= half ? std::int64_t{raw} - 2 * half : std::int64_t{raw};
  }
};

void refuse_if(bool condition, const char* why) {
  if (condition) throw std::runtime_error(why);
}

class Parser {
 public:
  Descriptor run(const std::uint8_t* bytes, std::size_t size) {
    std::size_t at = 0;
    while (at < size) take(next(bytes, size, at));
    refuse_if(!open_.empty(), "a collection is not closed");
    return found_;
  }

 private:
  static Item next(const std::uint8_t* bytes, std::size_t size, std::size_t& at) {
    const unsigned prefix = bytes[at++];
    refuse_if(prefix == 0xFE, "a long item");
    Item item;
    item.size = (prefix & 3U) == 3U ? 4 : static_cast<int>(prefix & 3U);
    item.type = static_cast<int>((prefix >> 2U) & 3U);
    item.tag = static_cast<int>(prefix >> 4U);
    refuse_if(at + static_cast<std::size_t>(item.size) > size, "an item is torn");
    for (int i = 0; i < item.size; ++i) {
      item.raw |= std::uint32_t{bytes[at++]} << (8U * static_cast<unsigned>(i));
    }
    return item;
  }

  void take(const Item& item) {
    if (item.type == 0) return main(item);
    if (item.type == 1) return global(item);
    refuse_if(item.type != 2, "a reserved type of item");
    local(item);
  }

  void global(const Item& item) {
    ParsedField& f = state_;
    switch (item.tag) {
      case 0:
        page_ = item.raw;
        return;
      case 1:
        f.low = item.with_sign();
        return;
      case 2:
        f.high = item.with_sign();
        return;
      case 3:
        f.physical_low = item.with_sign();
        return;
      case 4:
        f.physical_high = item.with_sign();
        return;
      case 5:
        f.exponent = static_cast<int>(item.with_sign());
        return;
      case 6:
        f.unit = static_cast<int>(item.raw);
        return;
      case 7:
        f.bits = static_cast<int>(item.raw);
        return;
      case 8:
        refuse_if(item.raw == 0 || item.raw > 255, "a report id that is none");
        f.report = static_cast<int>(item.raw);
        return;
      case 9:
        f.count = static_cast<int>(item.raw);
        return;
      default:
        refuse_if(true, "push, pop or a reserved global item");
    }
  }

  void local(const Item& item) {
    refuse_if(item.tag > 2, "a local item that is not a usage");
    const UsageCode code = item.size == 4 ? item.raw : (page_ << 16U) | item.raw;
    if (item.tag == 0) usages_.push_back(code);
    if (item.tag == 1) first_ = code;
    if (item.tag != 2) return;
    refuse_if(first_ == 0 || code < first_, "a range of usages that is none");
    for (UsageCode usage = first_; usage <= code; ++usage) usages_.push_back(usage);
  }

  void main(const Item& item) {
    switch (item.tag) {
      case 8:
        field('i', item.raw);
        break;
      case 9:
        field('o', item.raw);
        break;
      case 11:
        field('f', item.raw);
        break;
      case 10:
        begin(item.raw);
        break;
      case 12:
        refuse_if(open_.empty(), "an end without a collection");
        open_.pop_back();
        break;
      default:
        refuse_if(true, "a reserved main item");
    }
    usages_.clear();
    first_ = 0;
  }

  void begin(std::uint32_t type) {
    refuse_if(usages_.size() != 1, "a collection has one usage");
    const int parent = open_.empty() ? -1 : open_.back();
    refuse_if((parent < 0) != (type == 1), "application collections are outermost, and only they");
    found_.collections.push_back({static_cast<int>(type), usages_.front(), parent});
    open_.push_back(static_cast<int>(found_.collections.size()) - 1);
  }

  void field(char way, std::uint32_t flags) {
    refuse_if(open_.empty(), "a field outside of any collection");
    refuse_if(state_.report == 0, "a field without a report");
    refuse_if(state_.bits < 1 || state_.bits > 32 || state_.count < 1, "a field without bits");
    ParsedField f = state_;
    f.way = way;
    f.collection = open_.back();
    f.usages = usages_;
    f.constant = (flags & 1U) != 0;
    f.variable = (flags & 2U) != 0;
    int& filled = filled_[{way, f.report}];
    f.at_bit = filled;
    filled += f.bits * f.count;
    if (!f.constant) check_data(f);
    found_.fields.push_back(f);
  }

  static void check_data(const ParsedField& f) {
    refuse_if(f.usages.empty(), "data without a usage");
    refuse_if(f.low > f.high || f.physical_low > f.physical_high, "a range upside down");
    refuse_if(f.variable && f.usages.size() != static_cast<std::size_t>(f.count),
              "values without, or usages beyond, a value");
    const std::int64_t whole = std::int64_t{1} << f.bits;
    const std::int64_t half = whole / 2;
    refuse_if(f.low < 0 ? f.low < -half || f.high >= half : f.high >= whole,
              "a range that the bits do not hold");
  }

  Descriptor found_;
  ParsedField state_;
  std::uint32_t page_ = 0;
  std::vector<UsageCode> usages_;
  UsageCode first_ = 0;
  std::vector<int> open_;
  std::map<std::pair<char, int>, int> filled_;
};

}  // namespace

int Descriptor::bits_of(char way, int report) const {
  int bits = 0;
  for (const ParsedField& f : fields) {
    if (f.way == way && f.report == report) bits += f.bits * f.count;
  }
  return bits;
}

std::vector<int> Descriptor::reports(char way) const {
  std::vector<int> ids;
  for (const ParsedField& f : fields) {
    if (f.way == way && std::find(ids.begin(), ids.end(), f.report) == ids.end()) {
      ids.push_back(f.report);
    }
  }
  return ids;
}

Descriptor parse(const std::uint8_t* bytes, std::size_t size) {
  return Parser().run(bytes, size);
}

}  // namespace batuta::pid::test
