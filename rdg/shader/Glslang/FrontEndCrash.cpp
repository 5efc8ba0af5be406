// Halves a shader's text until the line is known that ends the front end.
#include "FrontEndCrash.h"

#include "DrydockAPI.h"
#include "TextTools.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace Drydock
{

namespace
{

struct FLine
{
	std::string Text;
	std::string File; // as the `#line` before says
	int Number = 0;
	size_t End = 0; // in the whole text, behind the line
};

std::vector<FLine> SplitLines(const std::string& Text, const std::string& VirtualPath)
{
	std::vector<FLine> Lines;
	std::istringstream Stream(Text);
	FLine Line{{}, VirtualPath, 0, 0};
	while (std::getline(Stream, Line.Text))
	{
		++Line.Number;
		Line.End += Line.Text.size() + 1;
		Lines.push_back(Line);
		const size_t Quote = Line.Text.find('"');
		if (Line.Text.starts_with("#line ") && Quote != std::string::npos)
		{
			Line.Number = std::atoi(Line.Text.c_str() + 6) - 1;
			Line.File = Line.Text.substr(Quote + 1, Line.Text.rfind('"') - Quote - 1);
		}
	}
	return Lines;
}

/** Whether the line has Name with a parenthesis behind it. */
bool Calls(const std::string& Line, const std::string& Name)
{
	for (size_t At = Line.find(Name); At != std::string::npos; At = Line.find(Name, At + 1))
	{
		const size_t Behind = Line.find_first_not_of(" \t", At + Name.size());
		if ((At == 0 || !IsWordCharacter(Line[At - 1])) && Behind != std::string::npos && Line[Behind] == '(')
		{
			return true;
		}
	}
	return false;
}

} // namespace

FCrashPlace FindCrashPlace(const std::string& Text, const FShaderCompileRequest& Request,
	const std::function<bool(const std::string& Text)>& Dies)
{
	if (Dies(""))
	{
		return {Request.VirtualPath, 0, ", as it is on an empty text: it is broken itself"};
	}
	const std::vector<FLine> Lines = SplitLines(Text, Request.VirtualPath);
	size_t Survived = 0;
	size_t Died = Lines.size();
	while (Died > Survived + 1)
	{
		const size_t Half = (Survived + Died) / 2;
		(Dies(Text.substr(0, Lines[Half - 1].End)) ? Died : Survived) = Half;
	}
	if (Died < Lines.size())
	{
		const FLine& Line = Lines[Died - 1];
		return {Line.File, Line.Number, " when it had read up to this line"};
	}
	FCrashPlace Entry{Request.VirtualPath, 0, " when it had read all of it"};
	for (const FLine& Line : Lines)
	{
		if (Calls(Line.Text, Request.EntryPoint))
		{
			Entry.File = Line.File;
			Entry.Line = Line.Number;
		}
	}
	return Entry;
}

} // namespace Drydock
