// Takes copied actors apart into blocks and properties. Line by line, as the engine reads it; only a (..) may go over
// several lines.
#include "PostProcessSettingsTextBlocks.h"

#include "PostProcessSettingsTextScan.h"
#include "RangeTools.h"
#include "TextTools.h"

#include <algorithm>
#include <charconv>

namespace Drydock
{

namespace
{

/** Deeper than any map. */
constexpr size_t MaxBlocks = 64;

/** The properties that a volume is made of; X, Y and Z are the size of a CubeBuilder. */
constexpr const char* ReadProperties[] = {"Settings", "Priority", "BlendRadius", "BlendWeight", "bEnabled", "bUnbound",
	"ActorLabel", "RelativeLocation", "RelativeRotation", "RelativeScale3D", "X", "Y", "Z"};

/** As the engine spells it; empty when it is none that is read. */
std::string FindProperty(const std::string& Name)
{
	const auto Found = std::ranges::find_if(
		ReadProperties, [&](const char* Property) { return ToLowerCase(Property) == ToLowerCase(Name); });
	return Found == std::end(ReadProperties) ? "" : *Found;
}

/** Without quotes. */
std::string Unquote(const std::string& Text)
{
	return Text.size() >= 2 && Text.front() == '"' && Text.back() == '"' ? Text.substr(1, Text.size() - 2) : Text;
}

class FBlockReader
{
public:
	FBlockReader(const std::string& InText, FSettingsTextMessages& InMessages)
		: Text(InText)
		, Messages(InMessages)
	{
		At = Text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
		Open.emplace_back();
	}

	FEngineTextBlock Read()
	{
		for (SkipEngineTextSpace(Text, At); At < Text.size(); SkipEngineTextSpace(Text, At))
		{
			ReadLine();
		}
		if (Open.size() > 1)
		{
			const FEngineTextBlock& Last = Open.back();
			Messages.Error(ErrorTextBlocks, Last.Offset, "", "Begin " + Last.Kind + " has no End " + Last.Kind);
		}
		while (Open.size() > 1)
		{
			Close();
		}
		return std::move(Open.front());
	}

private:
	void ReadLine()
	{
		const size_t Begin = At;
		const std::string Word = ReadEngineTextWord(Text, At);
		At += Word.size();
		const std::string Lower = ToLowerCase(Word);
		if (Lower == "begin" || Lower == "end")
		{
			SkipSpace();
			const std::string Kind = ReadEngineTextWord(Text, At);
			At += Kind.size();
			Lower == "begin" ? ReadBegin(Begin, Kind) : ReadEnd(Begin, Kind);
			SkipLine();
		}
		else if (Lower == "vertex")
		{
			ReadVertex();
		}
		else if (!ReadProperty(Begin, Word))
		{
			CheckOutside(Begin, Word);
			SkipLine();
		}
	}

	/** Attributes after Begin Actor: Class=/Script/Engine.PostProcessVolume Name="A" Archetype=... */
	void ReadBegin(size_t Begin, const std::string& Kind)
	{
		if (Open.size() > MaxBlocks)
		{
			Messages.Error(
				ErrorTextDepth, Begin, "", "blocks nested deeper than " + std::to_string(MaxBlocks) + " levels");
			At = Text.size();
			Open.resize(1);
			return;
		}
		FEngineTextBlock Block;
		Block.Kind = Kind;
		Block.Offset = Begin;
		for (SkipSpace(); At < Text.size() && Text[At] != '\n'; SkipSpace())
		{
			const std::string Name = ToLowerCase(ReadEngineTextWord(Text, At));
			At += std::max<size_t>(1, Name.size());
			if (Name.empty() || At >= Text.size() || Text[At] != '=')
			{
				continue;
			}
			const std::string Value = ReadAttribute();
			if (Name == "class")
			{
				Block.Class = Value.substr(Value.find_last_of("./") + 1); // npos + 1 is 0
			}
			else if (Name == "name")
			{
				Block.Name = Value;
			}
		}
		Open.push_back(std::move(Block));
	}

	/** The text after =, up to a space outside quotes. */
	std::string ReadAttribute()
	{
		const size_t Begin = ++At;
		for (bool bQuoted = false; At < Text.size() && Text[At] != '\n' && (bQuoted || !IsBlank(Text[At])); ++At)
		{
			bQuoted = bQuoted != (Text[At] == '"');
		}
		return Unquote(Text.substr(Begin, At - Begin));
	}

	void ReadEnd(size_t Begin, const std::string& Kind)
	{
		const auto IsOfKind = [&](const FEngineTextBlock& Block)
		{
			return ToLowerCase(Block.Kind) == ToLowerCase(Kind);
		};
		const FEngineTextBlock& Last = Open.back();
		if (Open.size() == 1)
		{
			Messages.Error(ErrorTextBlocks, Begin, "", "End " + Kind + " has no Begin " + Kind);
			return;
		}
		if (!IsOfKind(Last))
		{
			Messages.Error(ErrorTextBlocks, Begin, "",
				"expected End " + Last.Kind + " for the Begin " + Last.Kind + " at " + Messages.Place(Last.Offset) +
					", found End " + Kind);
			if (std::none_of(Open.begin() + 1, Open.end(), IsOfKind))
			{
				return;
			}
			while (!IsOfKind(Open.back()))
			{
				Close();
			}
		}
		Close();
	}

	/** Corners of polygons belong to the actor, or to what else has no polygons around it. */
	void Close()
	{
		FEngineTextBlock Block = std::move(Open.back());
		Open.pop_back();
		FEngineTextBlock& Parent = Open.back();
		const std::string Kind = ToLowerCase(Block.Kind);
		if (Kind == "polygon" || Kind == "polylist" || Kind == "brush")
		{
			Parent.Vertices.insert(Parent.Vertices.end(), Block.Vertices.begin(), Block.Vertices.end());
			return;
		}
		Parent.Blocks.push_back(std::move(Block));
	}

	/** "Vertex   -00100.000000,+00100.000000,-00100.000000" */
	void ReadVertex()
	{
		const size_t LineEnd = std::min(Text.find('\n', At), Text.size());
		double Numbers[3];
		int Num = 0;
		while (Num < 3)
		{
			while (At < LineEnd && (IsBlank(Text[At]) || Text[At] == ',' || Text[At] == '+'))
			{
				++At;
			}
			const std::from_chars_result Result =
				std::from_chars(Text.data() + At, Text.data() + LineEnd, Numbers[Num]);
			if (Result.ec != std::errc())
			{
				break;
			}
			At = static_cast<size_t>(Result.ptr - Text.data());
			++Num;
		}
		if (Num == 3)
		{
			Open.back().Vertices.insert(Open.back().Vertices.end(), std::begin(Numbers), std::end(Numbers));
		}
		SkipLine();
	}

	/** True when the line is done with: Name=Value of a property that is read. */
	bool ReadProperty(size_t Begin, const std::string& Word)
	{
		const std::string Name = FindProperty(Word);
		SkipSpace();
		if (Name.empty() || At >= Text.size() || Text[At] != '=')
		{
			return false;
		}
		++At;
		FEngineTextItem Item;
		Item.Name = Name;
		Item.Offset = Begin;
		SkipSpace();
		Item.Value.Offset = At;
		const bool bNothing = At >= Text.size() || Text[At] == '\n';
		if (!bNothing && !ParseEngineText(Text, At, Name, Item.Value, Messages))
		{
			SkipLine();
			return true;
		}
		SkipSpace();
		if (At < Text.size() && Text[At] != '\n')
		{
			Messages.Error(ErrorTextSyntax, At, Name,
				"expected the end of the line after the value of " + Name + ", found " +
					DescribeEngineTextAt(Text, At));
			SkipLine();
			return true;
		}
		FEngineTextBlock& Block = Open.back();
		if (const FEngineTextItem* Earlier = Block.Find(Name.c_str()))
		{
			Messages.Error(ErrorTextGivenTwice, Begin, Name,
				Name + " is given twice, first at " + Messages.Place(Earlier->Offset));
			return true;
		}
		Block.Properties.push_back(std::move(Item));
		return true;
	}

	/** Outside all blocks there is nothing to skip. */
	void CheckOutside(size_t Begin, const std::string& Word)
	{
		if (Open.size() == 1 && !bOutsideReported)
		{
			bOutsideReported = true;
			Messages.Error(ErrorTextSyntax, Begin, "",
				"expected (NAME=VALUE,..), Settings=(..) or Begin Map, found " +
					(Word.empty() ? DescribeEngineTextAt(Text, Begin) : DescribeEngineTextAt(Word, 0)));
		}
	}

	static bool IsBlank(char Character) { return Character == ' ' || Character == '\t' || Character == '\r'; }

	void SkipSpace()
	{
		while (At < Text.size() && IsBlank(Text[At]))
		{
			++At;
		}
	}

	void SkipLine() { At = std::min(Text.find('\n', At), Text.size()); }

	const std::string& Text;
	FSettingsTextMessages& Messages;
	size_t At = 0;
	std::vector<FEngineTextBlock> Open; // the first one is the text itself
	bool bOutsideReported = false;
};

} // namespace

const FEngineTextItem* FEngineTextBlock::Find(const char* Property) const
{
	return FindItem(Properties, Property, &FEngineTextItem::Name);
}

FEngineTextBlock ParseEngineTextBlocks(const std::string& Text, FSettingsTextMessages& Messages)
{
	return FBlockReader(Text, Messages).Read();
}

} // namespace Drydock
