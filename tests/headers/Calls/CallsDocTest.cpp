// The list of the calls that ran, compared with docs/calls.md; and what the compilers say of absent ones.
#include "Calls.h"

#include <gmock/gmock.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <vector>

namespace
{

using Calls::EArea;
using Calls::EState;

std::map<std::pair<EArea, EState>, std::vector<std::string>>& GetRecorded()
{
	static std::map<std::pair<EArea, EState>, std::vector<std::string>> Recorded;
	return Recorded;
}

std::string ReadFile(const std::string& Path)
{
	std::ifstream File(Path);
	return std::string(std::istreambuf_iterator<char>(File), {});
}

struct FAbsentCall
{
	std::string Line; // "12"
	std::string Name; // "UStaticMesh::GetRenderData"
	std::string WayRound;
};

const std::string AbsentFile = DRYDOCK_TEST_SOURCE_DIR "/tests/headers/Absent/AbsentCalls.cpp";

/** The calls of AbsentCalls.cpp: two comments, the way round and the name, before each. */
std::vector<FAbsentCall> ReadAbsentCalls()
{
	std::vector<FAbsentCall> Found;
	std::istringstream Lines(ReadFile(AbsentFile));
	std::string Line;
	std::vector<std::string> Comments;
	for (int Number = 1; std::getline(Lines, Line); ++Number)
	{
		if (Line.starts_with("\t// "))
		{
			Comments.push_back(Line.substr(4));
		}
		else if (Comments.size() == 2)
		{
			Found.push_back({std::to_string(Number), Comments[1], Comments[0]});
			Comments.clear();
		}
	}
	return Found;
}

std::string MakeDoc()
{
	std::string Doc;
	const char* const Titles[] = {"Views", "Families, extensions, scene textures", "The graph", "The RHI", "Core",
		"Objects and the world", "Shaders"};
	for (int Index = 0; Index < 7; ++Index)
	{
		for (const EState State : {EState::There, EState::Neutral})
		{
			const std::vector<std::string>& Names = GetRecorded()[{EArea(Index), State}];
			if (!Names.empty())
			{
				Doc += "\n### " + std::string(Titles[Index]) + (State == EState::There ? ": there (" : ": neutral (") +
					   std::to_string(Names.size()) + ")\n\n";
				for (const std::string& Name : Names)
				{
					Doc += "- " + Name + "\n";
				}
			}
		}
	}
	Doc += "\n### Absent\n\n| call | way round |\n|---|---|\n";
	for (const FAbsentCall& Call : ReadAbsentCalls())
	{
		Doc += "| `" + Call.Name + "` | " + Call.WayRound + " |\n";
	}
	return Doc;
}

/** After all tests: the page is what ran. */
class FCompareDoc : public testing::Environment
{
public:
	void TearDown() override
	{
		const testing::UnitTest& All = *testing::UnitTest::GetInstance();
		if (All.test_to_run_count() != All.total_test_count())
		{
			return;
		}
		const std::string Path = DRYDOCK_TEST_SOURCE_DIR "/docs/calls.md";
		const std::string Page = ReadFile(Path);
		const std::string Mark = "<!-- made by test_calls -->\n";
		const std::string Made = Page.substr(0, Page.find(Mark) + Mark.size()) + MakeDoc();
		if (std::getenv("DRYDOCK_BLESS") != nullptr)
		{
			std::ofstream(Path) << Made;
		}
		else if (Made != Page)
		{
			ADD_FAILURE() << "docs/calls.md differs from what ran; write it anew with DRYDOCK_BLESS=1";
		}
		size_t Num = 0;
		for (const auto& [Key, Names] : GetRecorded())
		{
			Num += Names.size();
		}
		EXPECT_LE(600u, Num);
	}
};

[[maybe_unused]] testing::Environment* const GCompareDoc = testing::AddGlobalTestEnvironment(new FCompareDoc);

std::string Compile(const std::string& Compiler)
{
	std::string Command = Compiler + " -std=c++20 -fsyntax-only -DGLM_FORCE_XYZW_ONLY -DGLM_FORCE_SILENT_WARNINGS";
	std::istringstream Folders(DRYDOCK_CALLS_INCLUDES);
	std::string Folder;
	while (std::getline(Folders, Folder, '|'))
	{
		Command += " -I'" + Folder + "'";
	}
	std::string Output;
	FILE* const Pipe = popen((Command + " '" + AbsentFile + "' 2>&1").c_str(), "r");
	std::array<char, 4096> Buffer;
	while (const size_t Count = std::fread(Buffer.data(), 1, Buffer.size(), Pipe))
	{
		Output.append(Buffer.data(), Count);
	}
	return pclose(Pipe) == 0 ? "" : Output;
}

} // namespace

void Calls::Record(EArea Area, EState State, const char* Name)
{
	std::vector<std::string>& Names = GetRecorded()[{Area, State}];
	if (std::find(Names.begin(), Names.end(), Name) == Names.end())
	{
		Names.emplace_back(Name);
	}
}

TEST(AbsentCalls, AreCompileErrorsThatNameTheWayRound)
{
	const std::vector<FAbsentCall> Absent = ReadAbsentCalls();
	EXPECT_EQ(11u, Absent.size());
	for (const char* const Compiler : {"g++", "clang++"})
	{
		if (std::system((std::string(Compiler) + " --version >/dev/null 2>&1").c_str()) != 0)
		{
			continue;
		}
		std::map<std::string, std::string> Errors; // by line
		std::istringstream Lines(Compile(Compiler));
		std::string Line;
		while (std::getline(Lines, Line))
		{
			if (Line.starts_with(AbsentFile + ":") && Line.find("error:") != std::string::npos)
			{
				const size_t Start = AbsentFile.size() + 1;
				Errors[Line.substr(Start, Line.find(':', Start) - Start)] += Line;
			}
		}
		EXPECT_EQ(Absent.size(), Errors.size()) << Compiler;
		for (const FAbsentCall& Call : Absent)
		{
			EXPECT_THAT(Errors[Call.Line],
				testing::HasSubstr(Call.Name.substr(Call.Name.find("::") + 2) + ": " + Call.WayRound))
				<< Compiler;
		}
	}
}
