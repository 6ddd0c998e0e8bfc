// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class MTReportTable
 * @brief named columns, rows of numbers and words; written as CSV, JSON, HTML and Markdown
 *
 * A column is a figure, which comes out the same to the last digit whenever the same program runs with the same
 * settings, or a time, which does not (so are memory and whatever depends on the clock). Files have all digits, pages
 * four. A number that is NaN was not measured.
 */
#ifndef MTReportTable_h
#define MTReportTable_h

#include <limits>
#include <string>
#include <type_traits>
#include <vector>

class MTReportTable
{
public:
  enum class Kind
  {
    Figure,
    Time
  };

  struct Column
  {
    std::string Name;
    std::string Unit; ///< empty: a count, a ratio or words
    Kind What = Kind::Figure;
  };

  /// A number or words.
  struct Cell
  {
    Cell(const char* words)
      : Words(words)
    {
    }
    Cell(std::string words)
      : Words(std::move(words))
    {
    }
    template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>>
    Cell(Number number)
      : IsNumber(true)
      , Value(static_cast<double>(number))
    {
    }

    bool IsNumber = false;
    double Value = std::numeric_limits<double>::quiet_NaN();
    std::string Words;
  };

  /// name: of the files, without ending.
  MTReportTable(std::string name, std::string caption, std::vector<Column> columns);

  /// One cell for each column; throws std::logic_error otherwise.
  void AddRow(std::vector<Cell> row);

  const std::string& GetName() const { return this->Name; }
  const std::string& GetCaption() const { return this->Caption; }
  const std::vector<std::vector<Cell>>& GetRows() const { return this->Rows; }

  ///@{
  /// Into the folder, as Name.csv and Name.json; throw std::runtime_error where that fails.
  void WriteCsv(const std::string& folder) const;
  void WriteJson(const std::string& folder) const;
  ///@}
  std::string ToHtml() const;
  std::string ToMarkdown() const;

  /// As pages show a number: four digits that count, "-" for NaN.
  static std::string Shorten(double number);

private:
  static std::string GetHeading(const Column& column);

  std::string Name;
  std::string Caption;
  std::vector<Column> Columns;
  std::vector<std::vector<Cell>> Rows;
};

#endif
