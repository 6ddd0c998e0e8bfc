// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportPage.h"

#include "MTReportFile.h"

#include <nlohmann/json.hpp>

using MTReportFile::EscapeHtml;
using MTReportFile::Wrap;

MTReportSection::MTReportSection(std::string title, std::string folder)
  : Title(std::move(title))
  , Folder(std::move(folder))
{
}

void MTReportSection::AddText(const std::string& text)
{
  this->Html += "<p>" + EscapeHtml(text) + "</p>\n";
  this->Markdown += Wrap(text) + "\n\n";
}

void MTReportSection::AddTable(const MTReportTable& table)
{
  table.WriteCsv(this->Folder);
  table.WriteJson(this->Folder);
  this->Html += table.ToHtml();
  this->Markdown += Wrap(table.GetCaption() + ":") + "\n\n" + table.ToMarkdown() + "\n";
}

void MTReportSection::AddChart(const MTReportChart& chart)
{
  if (chart.IsEmpty())
  {
    this->AddText(chart.GetTitle() + ": there is nothing to draw, all values are zero.");
    return;
  }
  chart.Write(this->Folder);
  this->AddPicture(chart.GetName() + ".png", chart.GetTitle());
}

void MTReportSection::AddPicture(const std::string& file, const std::string& caption)
{
  this->Html += "<figure><img src=\"" + file + "\" alt=\"" + EscapeHtml(caption) + "\"></figure>\n";
  this->Markdown += "![" + caption + "](" + file + ")\n\n";
}

void MTReportSection::AddClaim(const std::string& text, const std::string& figure, bool holds)
{
  this->Claims.push_back({ text, figure, holds, "" });
}

void MTReportSection::AddKnownClaim(
  const std::string& text, const std::string& figure, bool holds, const std::string& reason)
{
  this->Claims.push_back({ text, figure, holds, reason });
}

namespace
{
constexpr const char* Style =
  "body { font: 15px/1.45 sans-serif; max-width: 66em; margin: 2em auto; padding: 0 1em; }\n"
  "table { border-collapse: collapse; margin: 1em 0; font-size: 13px; }\n"
  "caption { text-align: left; padding: 4px 0; }\n"
  "th, td { border: 1px solid #ccc; padding: 2px 7px; text-align: left; }\n"
  "td.n { text-align: right; }\n"
  "figure { display: inline-block; margin: 4px; }\n"
  ".fails { color: #b00; font-weight: bold; }\n";

std::string GetVerdict(const MTReportClaim& claim)
{
  if (claim.KnownReason.empty())
  {
    return claim.Holds ? "holds" : "does not hold";
  }
  return claim.Holds ? "holds here" : "does not hold: " + claim.KnownReason;
}

std::string MakeHtml(
  const std::vector<std::pair<std::string, std::string>>& head, const std::vector<MTReportSection>& sections)
{
  std::string text = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Error against run "
                     "time</title>\n<style>\n" +
    std::string(Style) + "</style></head><body>\n<h1>Error against run time</h1>\n<table>\n";
  for (const auto& [name, value] : head)
  {
    text += "<tr><th>" + EscapeHtml(name) + "</th><td>" + EscapeHtml(value) + "</td></tr>\n";
  }
  text += "</table>\n<h2>Claims</h2>\n<table>\n<tr><th>part</th><th>claim</th><th>figure</th><th>verdict</th></tr>\n";
  for (const MTReportSection& section : sections)
  {
    for (const MTReportClaim& claim : section.GetClaims())
    {
      text += "<tr><td>" + EscapeHtml(section.GetTitle()) + "</td><td>" + EscapeHtml(claim.Text) + "</td><td>" +
        EscapeHtml(claim.Figure) + "</td><td" + (claim.Holds ? ">" : " class=\"fails\">") +
        EscapeHtml(GetVerdict(claim)) + "</td></tr>\n";
    }
  }
  text += "</table>\n";
  for (const MTReportSection& section : sections)
  {
    text += "<h2>" + EscapeHtml(section.GetTitle()) + "</h2>\n" + section.GetHtml();
  }
  return text + "</body></html>\n";
}

std::string MakeMarkdown(
  const std::vector<std::pair<std::string, std::string>>& head, const std::vector<MTReportSection>& sections)
{
  std::string text = "# Error against run time\n\n| | |\n|---|---|\n";
  for (const auto& [name, value] : head)
  {
    text += "| " + name + " | " + value + " |\n";
  }
  text += "\n## Claims\n\n| part | claim | figure | verdict |\n|---|---|---|---|\n";
  for (const MTReportSection& section : sections)
  {
    for (const MTReportClaim& claim : section.GetClaims())
    {
      const std::string mark = claim.Holds ? "" : "**";
      text += "| " + section.GetTitle() + " | " + claim.Text + " | " + claim.Figure + " | " + mark + GetVerdict(claim) +
        mark + " |\n";
    }
  }
  for (const MTReportSection& section : sections)
  {
    text += "\n## " + section.GetTitle() + "\n\n" + section.GetMarkdown();
  }
  while (text.size() > 1 && text[text.size() - 2] == '\n')
  {
    text.pop_back();
  }
  return text;
}

std::string MakeJson(const std::vector<MTReportSection>& sections)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const MTReportSection& section : sections)
  {
    for (const MTReportClaim& claim : section.GetClaims())
    {
      json.push_back({ { "part", section.GetTitle() }, { "claim", claim.Text }, { "figure", claim.Figure },
        { "holds", claim.Holds }, { "known", claim.KnownReason } });
    }
  }
  return json.dump(1) + "\n";
}
}

void MTReportPage::Write(const std::string& folder, const std::vector<std::pair<std::string, std::string>>& head,
  const std::vector<MTReportSection>& sections)
{
  MTReportFile::Write(folder + "/index.html", MakeHtml(head, sections));
  MTReportFile::Write(folder + "/report.md", MakeMarkdown(head, sections));
  MTReportFile::Write(folder + "/claims.json", MakeJson(sections));
}
