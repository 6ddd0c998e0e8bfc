// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportTable.h"

#include "MTReportFile.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace
{
std::string Print(const char* format, double number)
{
  char text[64];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

// In double quotes where it must be.
std::string QuoteForCsv(const std::string& words)
{
  if (words.find_first_of(",\"\n") == std::string::npos)
  {
    return words;
  }
  std::string quoted = "\"";
  for (const char c : words)
  {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + "\"";
}

std::string ShortenCell(const MTReportTable::Cell& cell)
{
  return cell.IsNumber ? MTReportTable::Shorten(cell.Value) : cell.Words;
}
}

MTReportTable::MTReportTable(std::string name, std::string caption, std::vector<Column> columns)
  : Name(std::move(name))
  , Caption(std::move(caption))
  , Columns(std::move(columns))
{
}

void MTReportTable::AddRow(std::vector<Cell> row)
{
  if (row.size() != this->Columns.size())
  {
    throw std::logic_error("table " + this->Name + ": a row of " + std::to_string(row.size()) + " cells");
  }
  this->Rows.push_back(std::move(row));
}

std::string MTReportTable::Shorten(double number)
{
  if (std::isnan(number))
  {
    return "-";
  }
  const bool isCount = number == std::floor(number) && std::abs(number) < 1e15;
  return Print(isCount ? "%.0f" : "%.4g", number);
}

std::string MTReportTable::GetHeading(const Column& column)
{
  return column.Unit.empty() ? column.Name : column.Name + " [" + column.Unit + "]";
}

void MTReportTable::WriteCsv(const std::string& folder) const
{
  std::string text;
  for (const Column& column : this->Columns)
  {
    text += (&column == this->Columns.data() ? "" : ",") + QuoteForCsv(GetHeading(column));
  }
  for (const std::vector<Cell>& row : this->Rows)
  {
    text += '\n';
    for (const Cell& cell : row)
    {
      const std::string number = std::isnan(cell.Value) ? "" : Print("%.17g", cell.Value);
      text += (&cell == row.data() ? "" : ",") + (cell.IsNumber ? number : QuoteForCsv(cell.Words));
    }
  }
  MTReportFile::Write(folder + "/" + this->Name + ".csv", text + "\n");
}

void MTReportTable::WriteJson(const std::string& folder) const
{
  nlohmann::ordered_json json;
  json["name"] = this->Name;
  json["caption"] = this->Caption;
  for (const Column& column : this->Columns)
  {
    json["columns"].push_back(
      { { "name", column.Name }, { "unit", column.Unit }, { "kind", column.What == Kind::Time ? "time" : "figure" } });
  }
  json["rows"] = nlohmann::ordered_json::array();
  for (const std::vector<Cell>& row : this->Rows)
  {
    nlohmann::ordered_json cells = nlohmann::ordered_json::array();
    for (const Cell& cell : row)
    {
      cells.push_back(!cell.IsNumber ? nlohmann::ordered_json(cell.Words)
          : std::isnan(cell.Value)   ? nlohmann::ordered_json(nullptr)
                                     : nlohmann::ordered_json(cell.Value));
    }
    json["rows"].push_back(cells);
  }
  MTReportFile::Write(folder + "/" + this->Name + ".json", json.dump(1) + "\n");
}

std::string MTReportTable::ToHtml() const
{
  std::string text = "<table>\n<caption>" + MTReportFile::EscapeHtml(this->Caption) + " (<a href=\"" + this->Name +
    ".csv\">CSV</a>, <a href=\"" + this->Name + ".json\">JSON</a>)</caption>\n<tr>";
  for (const Column& column : this->Columns)
  {
    text += "<th>" + MTReportFile::EscapeHtml(GetHeading(column)) + "</th>";
  }
  text += "</tr>\n";
  for (const std::vector<Cell>& row : this->Rows)
  {
    text += "<tr>";
    for (const Cell& cell : row)
    {
      text += (cell.IsNumber ? "<td class=\"n\">" : "<td>") + MTReportFile::EscapeHtml(ShortenCell(cell)) + "</td>";
    }
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

std::string MTReportTable::ToMarkdown() const
{
  std::string head = "|";
  std::string line = "|";
  for (const Column& column : this->Columns)
  {
    head += " " + GetHeading(column) + " |";
    line += "---|";
  }
  std::string text = head + "\n" + line + "\n";
  for (const std::vector<Cell>& row : this->Rows)
  {
    text += "|";
    for (const Cell& cell : row)
    {
      text += " " + ShortenCell(cell) + " |";
    }
    text += "\n";
  }
  return text;
}
