// Reads an ini file line by line.
#include "Objects/IniText.h"

#include "DiagnosticList.h"
#include "Objects/ObjectErrors.h"
#include "TextTools.h"

#include <algorithm>
#include <strings.h>

namespace Drydock
{

namespace
{

template<typename T>
T& FindOrAdd(std::vector<T>& Things, const std::string& Name)
{
	const auto Found = std::ranges::find_if(Things, [&](const T& Each) { return IsSameName(Each.Name, Name); });
	return Found != Things.end() ? *Found : Things.emplace_back(T{Name, {}});
}

/** `"a \"b\""` without quotes and escapes; false where the quotes do not close at the end. */
bool Unquote(const std::string& Text, std::string& OutText)
{
	OutText.clear();
	for (size_t At = 1; At < Text.size(); ++At)
	{
		if (Text[At] == '"')
		{
			return At + 1 == Text.size();
		}
		if (Text[At] == '\\' && At + 1 < Text.size())
		{
			++At;
			OutText += Text[At] == 'n' ? '\n' : Text[At] == 't' ? '\t' : Text[At];
			continue;
		}
		OutText += Text[At];
	}
	return false;
}

class FIniReader
{
public:
	FIniReader(const std::string& InFile, std::vector<FDiagnostic>& InDiagnostics)
		: File(InFile)
		, Diagnostics(InDiagnostics)
	{
	}

	void ReadLine(const std::string& Line, int InNumber)
	{
		Number = InNumber;
		const std::string Text = Trim(Line);
		if (Text.empty() || Text[0] == ';')
		{
			return;
		}
		if (Text[0] == '[')
		{
			ReadSection(Text);
			return;
		}
		const size_t Equals = Text.find('=');
		if (Equals == std::string::npos)
		{
			Warn(Text[0] == '/' || Text[0] == '#' ? "comments begin with ;" : "expected [Section] or Key=Value");
		}
		else if (SectionName.empty())
		{
			Warn("a key before any [Section]");
		}
		else
		{
			ReadKey(Trim(Text.substr(0, Equals)), Trim(Text.substr(Equals + 1)));
		}
	}

	std::vector<FIniSection> Sections;

private:
	void Warn(const std::string& What)
	{
		AddDiagnostic(Diagnostics, {.Severity = ESeverity::Warning,
									   .Code = WarnIniLine,
									   .Message = What + "; the line is left out",
									   .File = File,
									   .Line = Number});
	}

	void ReadSection(const std::string& Text)
	{
		const size_t End = Text.find(']');
		SectionName = End == std::string::npos ? "" : Trim(Text.substr(1, End - 1));
		if (SectionName.empty() || End + 1 != Text.size())
		{
			Warn("expected [Section]");
			return;
		}
		FindOrAdd(Sections, SectionName);
	}

	void ReadKey(std::string Name, const std::string& Text)
	{
		const char Command = Name.empty() ? '\0' : Name[0];
		const bool bCommand = std::string("+-.!").find(Command) != std::string::npos && Command != '\0';
		Name = bCommand ? Trim(Name.substr(1)) : Name;
		if (Name.empty() || std::string("@*^").find(Name[0]) != std::string::npos)
		{
			Warn(Name.empty() ? "there is no key before =" : "keys of structs (@, *) are not read");
			return;
		}
		if (Name.back() == ']')
		{
			Warn("elements of fixed arrays (Key[0]=) are not read");
			return;
		}
		FIniValue Value{Text, !Text.empty() && Text[0] == '"', Number};
		if (Value.bQuoted && !Unquote(Text, Value.Text))
		{
			Warn("the quotes do not close at the end of the line");
			return;
		}
		Apply(FindOrAdd(FindOrAdd(Sections, SectionName).Keys, Name).Values, bCommand ? Command : '=', Value);
	}

	static void Apply(std::vector<FIniValue>& Values, char Command, const FIniValue& Value)
	{
		const auto Same = [&](const FIniValue& Each)
		{
			return Each.Text == Value.Text;
		};
		switch (Command)
		{
		case '+':
			if (std::ranges::none_of(Values, Same))
			{
				Values.push_back(Value);
			}
			break;
		case '.':
			Values.push_back(Value);
			break;
		case '-':
			std::erase_if(Values, Same);
			break;
		case '!':
			Values.clear();
			break;
		default:
			Values = {Value};
			break;
		}
	}

	const std::string& File;
	std::vector<FDiagnostic>& Diagnostics;
	std::string SectionName; // empty: none, or one that is not understood
	int Number = 0;
};

} // namespace

bool IsSameName(const std::string& A, const std::string& B)
{
	return strcasecmp(A.c_str(), B.c_str()) == 0;
}

std::vector<FIniSection> ReadIniText(
	const std::string& Text, const std::string& File, std::vector<FDiagnostic>& Diagnostics)
{
	FIniReader Reader(File, Diagnostics);
	int Number = 0;
	for (const std::string& Line : SplitText(std::string_view(Text).substr(Text.starts_with("\xEF\xBB\xBF") ? 3 : 0)))
	{
		Reader.ReadLine(Line, ++Number);
	}
	return std::move(Reader.Sections);
}

} // namespace Drydock
