// Writes JUnit XML.
#include "Text/JUnit.h"

#include "Text/Fmt.inl"
#include "Text/TextFile.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** Bytes of the character of UTF-8 that begins at Begin; 0 where there is none that XML can hold. */
size_t CountCharacter(const std::string& Text, size_t Begin)
{
	const auto Byte = [&Text](size_t At)
	{
		return At < Text.size() ? static_cast<unsigned char>(Text[At]) : 0u;
	};
	const unsigned First = Byte(Begin);
	if (First < 0x80)
	{
		return First >= 0x20 || First == '\t' || First == '\n' || First == '\r' ? 1 : 0;
	}
	const size_t Count = First >= 0xC2 && First < 0xE0   ? 2
						 : First >= 0xE0 && First < 0xF0 ? 3
						 : First >= 0xF0 && First < 0xF5 ? 4
														 : 0;
	for (size_t Next = 1; Next < Count; ++Next)
	{
		if ((Byte(Begin + Next) & 0xC0) != 0x80)
		{
			return 0;
		}
	}
	const unsigned Second = Byte(Begin + 1);
	const bool bForbidden = (First == 0xE0 && Second < 0xA0) || (First == 0xED && Second >= 0xA0) || // surrogates
							(First == 0xF0 && Second < 0x90) || (First == 0xF4 && Second >= 0x90) ||
							(First == 0xEF && Second == 0xBF && Byte(Begin + 2) >= 0xBE);
	return bForbidden ? 0 : Count;
}

std::string Escape(const std::string& Text)
{
	std::string Escaped;
	for (size_t At = 0; At < Text.size();)
	{
		const size_t Count = CountCharacter(Text, At);
		const char Character = Text[At];
		Escaped += Count == 0          ? "?"
				   : Character == '&'  ? "&amp;"
				   : Character == '<'  ? "&lt;"
				   : Character == '>'  ? "&gt;"
				   : Character == '"'  ? "&quot;"
				   : Character == '\n' ? "&#10;"
				   : Character == '\r' ? "&#13;"
				   : Character == '\t' ? "&#9;"
									   : Text.substr(At, Count);
		At += std::max(Count, size_t(1));
	}
	return Escaped;
}

std::string MakeCase(const FJUnitCase& Case, const std::string& Suite)
{
	std::string Text = fmt::format(
		"    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"", Escape(Suite), Escape(Case.Name), Case.Seconds);
	std::string Inside;
	if (Case.Outcome != EJUnitOutcome::Passed)
	{
		const std::string First = Escape(Case.Message.substr(0, Case.Message.find('\n')));
		Inside += Case.Outcome == EJUnitOutcome::Skipped
					  ? fmt::format("      <skipped message=\"{}\"/>\n", First)
					  : fmt::format("      <{0} message=\"{1}\" type=\"{2}\">{3}</{0}>\n",
							Case.Outcome == EJUnitOutcome::Failed ? "failure" : "error", First,
							Case.Outcome == EJUnitOutcome::Failed ? "policy" : "mistake", Escape(Case.Message));
	}
	Inside += Case.Output.empty() ? "" : "      <system-out>" + Escape(Case.Output) + "</system-out>\n";
	return Text + (Inside.empty() ? "/>\n" : ">\n" + Inside + "    </testcase>\n");
}

long Count(const FJUnitSuite& Suite, EJUnitOutcome Outcome)
{
	return std::ranges::count_if(Suite.Cases, [Outcome](const FJUnitCase& Case) { return Case.Outcome == Outcome; });
}

} // namespace

std::string MakeJUnit(const std::vector<FJUnitSuite>& Suites)
{
	std::string Text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
	for (const FJUnitSuite& Suite : Suites)
	{
		double Seconds = 0.0;
		for (const FJUnitCase& Case : Suite.Cases)
		{
			Seconds += Case.Seconds;
		}
		Text += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" "
							"time=\"{:.3f}\">\n",
			Escape(Suite.Name), Suite.Cases.size(), Count(Suite, EJUnitOutcome::Failed),
			Count(Suite, EJUnitOutcome::Broken), Count(Suite, EJUnitOutcome::Skipped), Seconds);
		for (const FJUnitCase& Case : Suite.Cases)
		{
			Text += MakeCase(Case, Suite.Name);
		}
		Text += "  </testsuite>\n";
	}
	return Text + "</testsuites>\n";
}

void WriteJUnit(const std::string& File, const std::vector<FJUnitSuite>& Suites)
{
	WriteTextFile(File, MakeJUnit(Suites));
}

} // namespace Drydock
