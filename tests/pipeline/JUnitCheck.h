// What the schemas of Jenkins (junit-10.xsd) and Maven's Surefire say of JUnit XML, as far as both do: elements, where
// they may stand, attributes that they must and may have, and that the counts are those of the cases.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace JUnitTest
{

struct FElement
{
	std::string Name;
	std::map<std::string, std::string> Attributes;
	std::vector<FElement> Children;
	std::string Text;
};

/** Reads XML without namespaces, comments and CDATA. Throws std::runtime_error where it is not well-formed. */
class FXmlReader
{
public:
	explicit FXmlReader(const std::string& InText)
		: Text(InText)
	{
	}

	FElement ReadDocument()
	{
		Expect("<?xml version=\"1.0\" encoding=\"UTF-8\"?>");
		SkipBlanks();
		FElement Root = ReadElement();
		SkipBlanks();
		if (At != Text.size())
		{
			throw std::runtime_error("text behind the root");
		}
		return Root;
	}

private:
	void SkipBlanks()
	{
		while (At < Text.size() && (Text[At] == ' ' || Text[At] == '\n'))
		{
			++At;
		}
	}
	void Expect(const std::string& Wanted)
	{
		if (Text.compare(At, Wanted.size(), Wanted) != 0)
		{
			throw std::runtime_error("expected " + Wanted + " at " + std::to_string(At));
		}
		At += Wanted.size();
	}
	std::string ReadUntil(const std::string& Signs)
	{
		const size_t End = Text.find_first_of(Signs, At);
		if (End == std::string::npos)
		{
			throw std::runtime_error("ends too early");
		}
		const std::string Part = Text.substr(At, End - At);
		At = End;
		return Part;
	}
	static std::string Decode(const std::string& Raw)
	{
		static const std::map<std::string, std::string> Entities = {{"amp", "&"}, {"lt", "<"}, {"gt", ">"},
			{"quot", "\""}, {"apos", "'"}, {"#9", "\t"}, {"#10", "\n"}, {"#13", "\r"}};
		std::string Decoded;
		for (size_t Index = 0; Index < Raw.size(); ++Index)
		{
			if (static_cast<unsigned char>(Raw[Index]) < 0x20 && Raw[Index] != '\n')
			{
				throw std::runtime_error("a control character");
			}
			if (Raw[Index] != '&')
			{
				Decoded += Raw[Index];
				continue;
			}
			const size_t End = Raw.find(';', Index);
			Decoded += Entities.at(Raw.substr(Index + 1, End - Index - 1)); // throws std::out_of_range
			Index = End;
		}
		return Decoded;
	}
	FElement ReadElement()
	{
		FElement Element;
		Expect("<");
		Element.Name = ReadUntil(" />");
		for (SkipBlanks(); Text.at(At) != '>' && Text.at(At) != '/'; SkipBlanks())
		{
			const std::string Name = ReadUntil("=");
			Expect("=\"");
			const std::string Value = ReadUntil("\"<");
			Expect("\"");
			if (!Element.Attributes.emplace(Name, Decode(Value)).second)
			{
				throw std::runtime_error("attribute twice: " + Name);
			}
		}
		if (Text[At] == '/')
		{
			Expect("/>");
			return Element;
		}
		Expect(">");
		for (;;)
		{
			Element.Text += Decode(ReadUntil("<"));
			if (Text.compare(At, 2, "</") == 0)
			{
				Expect("</" + Element.Name + ">");
				return Element;
			}
			Element.Children.push_back(ReadElement());
		}
	}

	const std::string& Text;
	size_t At = 0;
};

inline bool IsNumber(const std::string& Text, bool bWhole)
{
	return !Text.empty() && Text.find_first_not_of(bWhole ? "0123456789" : "0123456789.") == std::string::npos;
}

/** What may stand in an element: attributes with whether they must, and children with how many at most. */
struct FRule
{
	std::map<std::string, bool> Attributes;
	std::map<std::string, size_t> Children;
};

inline void CheckElement(const FElement& Element)
{
	constexpr size_t Any = 1000000;
	static const std::map<std::string, FRule> Rules = {{"testsuites", {{}, {{"testsuite", Any}}}},
		{"testsuite", {{{"name", true}, {"tests", true}, {"failures", true}, {"errors", true}, {"skipped", false},
						   {"time", false}},
						  {{"testcase", Any}}}},
		{"testcase", {{{"name", true}, {"classname", true}, {"time", false}},
						 {{"skipped", 1}, {"failure", 1}, {"error", 1}, {"system-out", 1}}}},
		{"skipped", {{{"message", false}}, {}}}, {"failure", {{{"message", false}, {"type", true}}, {}}},
		{"error", {{{"message", false}, {"type", true}}, {}}}, {"system-out", {{}, {}}}};
	ASSERT_EQ(1u, Rules.count(Element.Name)) << Element.Name;
	const FRule& Rule = Rules.at(Element.Name);
	for (const auto& [Name, bMust] : Rule.Attributes)
	{
		EXPECT_TRUE(!bMust || Element.Attributes.count(Name) == 1) << Element.Name << " without " << Name;
	}
	for (const auto& [Name, Value] : Element.Attributes)
	{
		EXPECT_EQ(1u, Rule.Attributes.count(Name)) << Element.Name << " with " << Name;
		const bool bCount = Name == "tests" || Name == "failures" || Name == "errors" || Name == "skipped";
		EXPECT_TRUE(!bCount || IsNumber(Value, true)) << Name << " " << Value;
		EXPECT_TRUE(Name != "time" || IsNumber(Value, false)) << Value;
	}
	std::map<std::string, size_t> Counts;
	for (const FElement& Child : Element.Children)
	{
		EXPECT_EQ(1u, Rule.Children.count(Child.Name)) << Child.Name << " in " << Element.Name;
		EXPECT_LE(++Counts[Child.Name], Rule.Children.count(Child.Name) == 1 ? Rule.Children.at(Child.Name) : 0u);
		CheckElement(Child);
	}
	if (Element.Name == "testcase")
	{
		EXPECT_GE(1u, Counts["skipped"] + Counts["failure"] + Counts["error"]);
		EXPECT_TRUE(Counts["system-out"] == 0 || Element.Children.back().Name == "system-out");
	}
	EXPECT_TRUE(Rule.Children.empty() || Element.Text.find_first_not_of(" \n") == std::string::npos) << Element.Name;
}

/** The suites of a document, which is checked. */
inline std::vector<FElement> ReadSuites(const std::string& Text)
{
	const FElement Root = FXmlReader(Text).ReadDocument();
	EXPECT_EQ("testsuites", Root.Name);
	CheckElement(Root);
	for (const FElement& Suite : Root.Children)
	{
		std::map<std::string, size_t> Counts;
		std::set<std::string> Names;
		for (const FElement& Case : Suite.Children)
		{
			EXPECT_TRUE(Names.insert(Case.Attributes.at("name")).second) << Case.Attributes.at("name") << " twice";
			for (const FElement& Child : Case.Children)
			{
				++Counts[Child.Name];
			}
		}
		EXPECT_EQ(std::to_string(Suite.Children.size()), Suite.Attributes.at("tests"));
		EXPECT_EQ(std::to_string(Counts["failure"]), Suite.Attributes.at("failures"));
		EXPECT_EQ(std::to_string(Counts["error"]), Suite.Attributes.at("errors"));
		EXPECT_EQ(std::to_string(Counts["skipped"]), Suite.Attributes.at("skipped"));
	}
	return Root.Children;
}

/** Null where the suite has no such case. */
inline const FElement* FindCase(const FElement& Suite, const std::string& Name)
{
	for (const FElement& Case : Suite.Children)
	{
		if (Case.Attributes.at("name") == Name)
		{
			return &Case;
		}
	}
	return nullptr;
}

/** "failure", "error", "skipped", or nothing of one that passed. */
inline std::string GetOutcome(const FElement& Case)
{
	for (const FElement& Child : Case.Children)
	{
		if (Child.Name != "system-out")
		{
			return Child.Name;
		}
	}
	return "";
}

} // namespace JUnitTest
