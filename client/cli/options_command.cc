#include "client/cli/options_command.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace fovea::cli {
namespace {

using Row = std::vector<std::string>;

std::string Text(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

Row RowOf(const v1::Option& option, const v1::GetServerInfoResponse& info) {
  Row row{option.name()};
  for (const std::string& profile : info.profiles()) {
    const auto value = option.defaults().find(profile);
    row.push_back(value == option.defaults().end() ? "" : Text(value->second));
  }
  row.push_back(Text(option.minimum()) + " to " + Text(option.maximum()) +
                (option.integral() ? ", whole" : ""));
  row.push_back(option.unit());
  row.push_back(option.description());
  return row;
}

// Columns as wide as their longest text; the last one as it comes.
void Print(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  for (const Row& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      std::cout << std::left << std::setw(static_cast<int>(widths[i]) + 2) << row[i];
    }
    std::cout << row.back() << '\n';
  }
}

}  // namespace

void PrintOptions(const std::string& heading, const client::Client& client) {
  const v1::GetServerInfoResponse info = client.GetServerInfo();
  Row head{"option"};
  head.insert(head.end(), info.profiles().begin(), info.profiles().end());
  head.insert(head.end(), {"range", "unit", "meaning"});
  std::vector<Row> rows{head};
  const v1::ListOptionsResponse list = client.ListOptions();
  for (const v1::Option& option : list.options()) rows.push_back(RowOf(option, info));
  std::cout << heading;
  Print(rows);
}

}  // namespace fovea::cli
