// Writes JSON text with indents, the shortest numbers that read back, and the string escapes of RFC 8259.
#include "Text/JsonWriter.h"

#include "Text/Fmt.inl"
#include "Text/TextFormat.h"
#include "TextTools.h"

#include <cmath>

namespace Drydock
{

std::string FJsonWriter::Quote(const std::string& Text)
{
	std::string Quoted = "\"";
	for (const char Character : Text)
	{
		const std::string_view Escape = FindEscape(Character);
		if (Escape.empty() && static_cast<unsigned char>(Character) < 0x20)
		{
			Quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(Character));
			continue;
		}
		Escape.empty() ? Quoted += Character : Quoted += Escape;
	}
	return Quoted + "\"";
}

FJsonWriter& FJsonWriter::Key(const std::string& Name)
{
	Separate();
	Text += Quote(Name) + ": ";
	bAfterKey = true;
	return *this;
}

void FJsonWriter::Value(const std::string& InText)
{
	Raw(Quote(InText));
}

void FJsonWriter::Value(bool bValue)
{
	Raw(bValue ? "true" : "false");
}

void FJsonWriter::Value(double Number)
{
	Raw(std::isfinite(Number) ? NumberText(Number) : "null");
}

void FJsonWriter::Value(float Number)
{
	Raw(std::isfinite(Number) ? NumberText(Number) : "null");
}

void FJsonWriter::Raw(const std::string& Json)
{
	Separate();
	Text += Json;
}

void FJsonWriter::RawMember(const std::string& Name, const std::string& Json)
{
	if (!Json.empty())
	{
		Key(Name).Raw(Json);
	}
}

void FJsonWriter::Members(std::initializer_list<FMember> Each)
{
	for (const FMember& One : Each)
	{
		Key(One.Name).Raw(One.Json);
	}
}

void FJsonWriter::Object(std::initializer_list<FMember> Each)
{
	BeginObject(true);
	Members(Each);
	EndObject();
}

void FJsonWriter::Begin(char Bracket, bool bInline)
{
	Separate();
	Text += Bracket;
	const bool bParentInline = !Levels.empty() && Levels.back().bInline;
	Levels.push_back({Bracket == '{' ? '}' : ']', bInline || bParentInline, true});
}

std::string FJsonWriter::GetText()
{
	while (!Levels.empty())
	{
		End();
	}
	return Text + "\n";
}

void FJsonWriter::End()
{
	const FLevel Level = Levels.back();
	Levels.pop_back();
	if (!Level.bInline && !Level.bEmpty)
	{
		BreakLine();
	}
	Text += Level.Closing;
}

void FJsonWriter::Separate()
{
	if (bAfterKey)
	{
		bAfterKey = false;
		return;
	}
	if (Levels.empty())
	{
		return;
	}
	FLevel& Level = Levels.back();
	if (!Level.bEmpty)
	{
		Text += Level.bInline ? ", " : ",";
	}
	Level.bEmpty = false;
	if (!Level.bInline)
	{
		BreakLine();
	}
}

void FJsonWriter::BreakLine()
{
	Text += '\n';
	Text.append(Levels.size() * 2, ' ');
}

} // namespace Drydock
