// Writes what `drydock blend` says as text: volumes, and the story of each setting in columns.
#include "Blend/BlendReport.h"

#include "HAL/IConsoleManager.h"
#include "PrintText.h"
#include "SettingObjects.h"
#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"
#include "Text/GlobPattern.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

const char* const Bold = "\x1b[1m";
const char* const Dim = "\x1b[2m";
const char* const Plain = "\x1b[0m";

/** Five digits are enough to read; --json has all of them. */
std::string FormatValue(const FSettingField& Field, const FSettingValue& Value)
{
	const int32 NumComponents = Field.GetNumComponents();
	if (Field.Type == ESettingType::Float)
	{
		return fmt::format("{:.5g}", Value.Components[0]);
	}
	if (NumComponents < 2)
	{
		return SettingToText(Field, Value);
	}
	std::string Text;
	for (int32 Index = 0; Index < NumComponents; ++Index)
	{
		const bool bNewColor = Field.Type == ESettingType::ColorArray && Index % 4 == 0;
		Text += std::string(Index == 0  ? "("
							: bNewColor ? ") ("
										: ", ") +
				fmt::format("{:.4g}", Value.Components[Index]);
	}
	return Text + ")";
}

std::string FormatDistance(const std::optional<double>& Distance)
{
	return !Distance ? "" : *Distance < 1e7 ? fmt::format("{:.1f} cm", *Distance) : fmt::format("{:.4g} cm", *Distance);
}

std::string FormatWeight(const std::optional<float>& Weight)
{
	return Weight ? fmt::format("{:.4g} %", 100.0 * static_cast<double>(*Weight)) : "";
}

/** Lines of cells in columns as wide as their widest cell. */
class FColumns
{
public:
	struct FRow
	{
		std::vector<std::string> Cells; // the last one of a dim row or title takes no part in the widths
		bool bDim = false;
		bool bTitle = false;
	};

	/** One letter per column: l or r, how it is aligned. */
	explicit FColumns(std::string InAlignment)
		: Alignment(std::move(InAlignment))
	{
	}

	void Add(FRow Row)
	{
		for (std::string& Cell : Row.Cells)
		{
			Cell = MakePrintable(Cell, false);
		}
		Rows.push_back(std::move(Row));
	}

	std::string Print(bool bColorful) const
	{
		std::vector<size_t> Widths(Alignment.size());
		for (const FRow& Row : Rows)
		{
			for (size_t Column = 0; Column < CountMeasured(Row); ++Column)
			{
				Widths[Column] = std::max(Widths[Column], Row.Cells[Column].size());
			}
		}
		std::string Text;
		for (const FRow& Row : Rows)
		{
			Text += Colored(PrintRow(Row, Widths), Row, bColorful) + "\n";
		}
		return Text;
	}

private:
	static size_t CountMeasured(const FRow& Row) { return Row.Cells.size() - (Row.bDim || Row.bTitle ? 1 : 0); }

	std::string PrintRow(const FRow& Row, const std::vector<size_t>& Widths) const
	{
		std::string Line;
		for (size_t Column = 0; Column < Row.Cells.size(); ++Column)
		{
			const std::string& Cell = Row.Cells[Column];
			const bool bMeasured = Column < CountMeasured(Row);
			const std::string Space(bMeasured ? Widths[Column] - Cell.size() : 0, ' ');
			Line += (Column > 0 ? "  " : "") + (Alignment[Column] == 'r' ? Space + Cell : Cell + Space);
		}
		return Line.substr(0, Line.find_last_not_of(' ') + 1);
	}

	static std::string Colored(const std::string& Line, const FRow& Row, bool bColorful)
	{
		const char* const Color = Row.bTitle ? Bold : Row.bDim ? Dim : "";
		return bColorful && Color[0] != '\0' ? Color + Line + Plain : Line;
	}

	std::string Alignment;
	std::vector<FRow> Rows;
};

/** How many a line names. */
constexpr size_t MaxNamed = 6;

std::string PrintVolumes(const FBlendReport& Report, bool bColorful)
{
	if (Report.Volumes.empty())
	{
		return "";
	}
	FColumns Columns("llrrrl");
	Columns.Add({{" ", "volume", "Priority", "distance", "weight", ""}, true});
	for (const FVolumeAtPlace& Place : Report.Volumes)
	{
		const FPostProcessVolumeProperties& Properties = Report.VolumeProperties[Place.Volume];
		const bool bSkipped = Place.Influence.Skip != EVolumeSkip::None;
		const std::string Skip = ExplainSkip(Place.Influence.Skip, Properties, Place.Distance.value_or(0.0));
		Columns.Add({{bSkipped ? "-" : " ", Report.VolumeNames[Place.Volume],
						 fmt::format("{:g}", static_cast<double>(Properties.Priority)),
						 Properties.bIsUnbound ? "unbound" : FormatDistance(Place.Distance),
						 bSkipped ? Skip : FormatWeight(Place.Influence.Weight)},
			bSkipped});
	}
	return Columns.Print(bColorful) + "\n";
}

/** Many volumes of one fate are told in one line: those that leave the setting alone always, the skipped ones beyond
 * the first few. */
void AddStory(const FBlendReport& Report, size_t FieldIndex, FColumns& Columns)
{
	constexpr size_t MaxSkipped = 8;
	const FSettingField& Field = GetSettingFields()[FieldIndex];
	std::vector<std::string> Inert;
	size_t NumSkipped = 0;
	for (const FBlendLedgerEntry& Entry : Report.Ledger.GetEntries(FieldIndex))
	{
		if (Entry.Skipped == "override off")
		{
			Inert.push_back(Entry.Source);
		}
		else if (Entry.Skipped.empty())
		{
			Columns.Add({{" ", Entry.Source, FormatDistance(Entry.Distance), FormatWeight(Entry.Weight), Entry.Rule,
				FormatValue(Field, Entry.After), Entry.Detail}});
		}
		else if (++NumSkipped <= MaxSkipped)
		{
			Columns.Add({{"-", Entry.Source, FormatDistance(Entry.Distance), Entry.Skipped}, true});
		}
	}
	if (NumSkipped > MaxSkipped)
	{
		Columns.Add({{"-", std::to_string(NumSkipped - MaxSkipped) + " more skipped", "", "--json has all"}, true});
	}
	if (!Inert.empty())
	{
		Columns.Add({{"-", "override off", "", ListSome(Inert, MaxNamed)}, true});
	}
}

/** Whether a console variable has not been set by anybody. */
bool IsAtDefault(const std::string& Variable)
{
	const IConsoleVariable* Found = IConsoleManager::Get().FindConsoleVariable(Variable.c_str());
	return Found != nullptr && (Found->GetFlags() & ECVF_SetByMask) == ECVF_SetByConstructor;
}

/** Settings that something names, although nothing acts on them here. */
std::vector<std::string> FindNamedOnly(const FBlendReport& Report, const std::vector<size_t>& Changed)
{
	std::vector<std::string> Names;
	for (size_t Index = 0; Index < GetSettingFields().size(); ++Index)
	{
		const std::vector<FBlendLedgerEntry>& Entries = Report.Ledger.GetEntries(Index);
		const bool bNamed = std::any_of(Entries.begin(), Entries.end(),
			[](const FBlendLedgerEntry& Entry) { return !Entry.Skipped.empty() && Entry.Skipped != "override off"; });
		if (bNamed && std::find(Changed.begin(), Changed.end(), Index) == Changed.end())
		{
			Names.emplace_back(GetSettingFields()[Index].Name);
		}
	}
	return Names;
}

std::string PrintRest(const FBlendReport& Report, const std::vector<size_t>& Changed)
{
	const size_t NumRest = GetSettingFields().size() - Changed.size();
	const std::vector<std::string> Named = FindNamedOnly(Report, Changed);
	std::string Text = fmt::format("{} {} at their defaults; --setting NAME shows one, --json shows all\n", NumRest,
		Changed.empty() ? "settings: all" : "other settings");
	if (!Named.empty())
	{
		Text += "named, but nothing that names them acts here: " + ListSome(Named, MaxNamed) + "\n";
	}
	return Text;
}

std::string PrintBlendables(const FBlendReport& Report)
{
	std::string Text;
	for (const FWeightedBlendable& Blendable : Report.Blended.Settings.BlendableManager.Blendables)
	{
		Text += "blendable  " + GetObjectPath(Blendable.Object.Get()) + "  " + FormatWeight(Blendable.Weight) + "\n";
	}
	return Text.empty() ? "" : Text + "\n";
}

} // namespace

std::vector<size_t> FindSettings(const std::vector<std::string>& Patterns)
{
	const std::vector<FSettingField>& Fields = GetSettingFields();
	std::vector<bool> Wanted(Fields.size());
	std::vector<FDiagnostic> Diagnostics;
	for (const std::string& Pattern : Patterns)
	{
		bool bFound = false;
		for (size_t Index = 0; Index < Fields.size(); ++Index)
		{
			const bool bMatches = MatchesPattern(Pattern, Fields[Index].Name);
			Wanted[Index] = Wanted[Index] || bMatches;
			bFound = bFound || bMatches;
		}
		if (!bFound)
		{
			Diagnostics.push_back({.Code = ErrorUnknownSetting,
				.Message = "unknown setting " + Pattern + SuggestName(Pattern, GetSettingNames()),
				.Where = "--setting"});
		}
	}
	if (!Diagnostics.empty())
	{
		throw FError(Diagnostics, ExitUsage);
	}
	std::vector<size_t> Indices;
	for (size_t Index = 0; Index < Fields.size(); ++Index)
	{
		if (Wanted[Index])
		{
			Indices.push_back(Index);
		}
	}
	return Indices;
}

std::vector<size_t> FindChangedSettings(const FBlendReport& Report)
{
	std::vector<size_t> Changed;
	for (size_t Index = 0; Index < GetSettingFields().size(); ++Index)
	{
		const std::vector<FBlendLedgerEntry>& Entries = Report.Ledger.GetEntries(Index);
		const bool bActed = std::any_of(Entries.begin(), Entries.end(),
			[](const FBlendLedgerEntry& Entry)
			{
				return Entry.Kind != EBlendSource::Default && Entry.Skipped.empty() &&
					   (Entry.Kind != EBlendSource::Variable || !IsAtDefault(Entry.Source));
			});
		if (bActed)
		{
			Changed.push_back(Index);
		}
	}
	return Changed;
}

std::string MakeBlendText(const FBlendReport& Report, const std::vector<size_t>& Settings, bool bRest, bool bColorful)
{
	std::string Text = fmt::format("{} at {:.6g}, {:.6g}, {:.6g} ({})\n\n{}", Report.Config, Report.Location.X,
		Report.Location.Y, Report.Location.Z, Report.LocationFrom, PrintVolumes(Report, bColorful));
	FColumns Columns("llrrlll");
	for (const size_t Index : Settings)
	{
		const FSettingField& Field = GetSettingFields()[Index];
		Columns.Add({{std::string(Field.Name) + " = " + FormatValue(Field, Field.Get(Report.Blended.Settings)) +
						 (Field.Unit[0] != '\0' ? std::string(" ") + Field.Unit : "")},
			false, true});
		AddStory(Report, Index, Columns);
		Columns.Add({{""}, false, true});
	}
	Text += Columns.Print(bColorful) + PrintBlendables(Report);
	return bRest ? Text + PrintRest(Report, Settings) : Text;
}

} // namespace Drydock
