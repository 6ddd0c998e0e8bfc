// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class MTReportPage
 * @brief what the report shows: a section for each part, with text, tables, charts, pictures and claims
 *
 * Tables and charts are written into the folder as soon as they are added; the page itself, as index.html and as
 * report.md, at the end.
 */
#ifndef MTReportPage_h
#define MTReportPage_h

#include "MTReportChart.h"
#include "MTReportTable.h"

#include <string>
#include <vector>

/// Something that the toolkit is to do, what was found, and whether it holds.
struct MTReportClaim
{
  std::string Text;   ///< a sentence that can be false
  std::string Figure; ///< what it was judged by
  bool Holds = false;
  /// Why it is known not to hold, where it is: it is shown like any other, and the program does not fail by it.
  std::string KnownReason;
};

class MTReportSection
{
public:
  /// folder: where tables and charts go.
  MTReportSection(std::string title, std::string folder);

  /// A paragraph of plain text.
  void AddText(const std::string& text);
  void AddTable(const MTReportTable& table);
  void AddChart(const MTReportChart& chart);
  /// A picture that is in the folder already.
  void AddPicture(const std::string& file, const std::string& caption);
  void AddClaim(const std::string& text, const std::string& figure, bool holds);
  /// One that may fail without the program's failing, for a reason that the page gives.
  void AddKnownClaim(const std::string& text, const std::string& figure, bool holds, const std::string& reason);

  const std::string& GetTitle() const { return this->Title; }
  const std::vector<MTReportClaim>& GetClaims() const { return this->Claims; }
  const std::string& GetHtml() const { return this->Html; }
  const std::string& GetMarkdown() const { return this->Markdown; }

private:
  std::string Title;
  std::string Folder;
  std::vector<MTReportClaim> Claims;
  std::string Html;
  std::string Markdown;
};

namespace MTReportPage
{
/// head: facts of the run, name and value each. Writes index.html, report.md and claims.json into the folder; throws
/// std::runtime_error where that fails.
void Write(const std::string& folder, const std::vector<std::pair<std::string, std::string>>& head,
  const std::vector<MTReportSection>& sections);
}

#endif
