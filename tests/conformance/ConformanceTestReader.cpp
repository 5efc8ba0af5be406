// Splits the file of a test into its parts and follows its run lines.
#include "ConformanceTest.h"

#include <cctype>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

namespace Drydock::Conformance
{

namespace
{

struct FParts
{
	std::map<std::string, std::string> Files; // by name
	std::vector<std::string> RunLines;
	std::vector<std::string> CheckLines;
	int32_t WaveSize = 0;
	int32_t NumUnsupported = 0; // compilers that the suite does not ask
};

/** "source.hlsl" of "//--- source.hlsl" and "#--- source.hlsl"; empty for other lines. */
std::string GetPartName(const std::string& Line)
{
	const size_t Sign = Line.starts_with("//") ? 2 : Line.starts_with("#") ? 1 : 0;
	if (Sign == 0 || Line.compare(Sign, 4, "--- ") != 0)
	{
		return {};
	}
	const std::string Name = Line.substr(Sign + 4);
	return Name.substr(0, Name.find_last_not_of(" \t\r") + 1);
}

FParts Split(const std::string& Path)
{
	std::ifstream Stream(Path);
	if (!Stream)
	{
		throw FNotRead("the file cannot be read");
	}
	FParts Parts;
	std::string* Part = nullptr;
	std::string Line;
	for (int32_t Number = 1; std::getline(Stream, Line); ++Number)
	{
		if (const std::string Name = GetPartName(Line); !Name.empty())
		{
			Part = &Parts.Files[Name];
			Part->assign(size_t(Number), '\n'); // so that its lines have the file's numbers
			continue;
		}
		if (const size_t At = Line.find("RUN:"); At != std::string::npos)
		{
			Parts.RunLines.push_back(Line.substr(At + 4));
		}
		for (const std::string Check : {"CHECK:", "CHECK-NEXT:", "CHECK-LABEL:"})
		{
			if (const size_t At = Line.find(Check); At != std::string::npos)
			{
				Parts.CheckLines.push_back(Line.substr(At + Check.size()));
			}
		}
		const bool bCompiler = Line.ends_with("UNSUPPORTED: DXC") || Line.ends_with("UNSUPPORTED: Clang");
		Parts.NumUnsupported += bCompiler ? 1 : 0;
		const size_t Wave = Line.find("REQUIRES") == std::string::npos ? std::string::npos : Line.find("WaveSize_");
		if (Wave != std::string::npos)
		{
			Parts.WaveSize = std::atoi(Line.c_str() + Wave + 9);
		}
		if (Part)
		{
			*Part += Line + '\n';
		}
	}
	return Parts;
}

/** The words of a run line; what stands in %if ... %{ ... %} is of one API and left out. */
std::vector<std::string> GetWords(const std::string& RunLine)
{
	std::istringstream Stream(RunLine);
	std::vector<std::string> Words;
	std::string Word;
	bool bCondition = false;
	while (Stream >> Word)
	{
		bCondition = bCondition || Word == "%if";
		if (!bCondition)
		{
			Words.push_back(Word);
		}
		bCondition = bCondition && Word != "%}";
	}
	return Words;
}

const std::string& FindPart(const FParts& Parts, const std::string& Name)
{
	const auto Found = Parts.Files.find(Name.substr(Name.find('/') + 1));
	if (Found == Parts.Files.end())
	{
		throw FNotRead("no part '" + Name + "'");
	}
	return Found->second;
}

/** What "%dxc_target -T cs_6_0 -Fo %t.o %t/source.hlsl" makes, and its name. */
std::pair<std::string, FShaderSourceText> ReadCompilation(const FParts& Parts, const std::vector<std::string>& Words)
{
	FShaderSourceText Shader;
	std::string Object;
	for (size_t i = 1; i < Words.size(); ++i)
	{
		const std::string& Word = Words[i];
		if (Word == "-T" && i + 1 < Words.size() && !Words[i + 1].starts_with("cs_"))
		{
			throw FNotRead("a shader of the profile " + Words[i + 1]);
		}
		if (Word == "-Fo" && i + 1 < Words.size())
		{
			Object = Words[++i];
		}
		else if (Word.starts_with("-D"))
		{
			const std::string Define = Word.size() > 2 || i + 1 == Words.size() ? Word.substr(2) : Words[++i];
			const size_t Equals = Define.find('=');
			Shader.Defines.emplace_back(
				Define.substr(0, Equals), Equals == std::string::npos ? "1" : Define.substr(Equals + 1));
		}
		else if (Word == "-enable-16bit-types")
		{
			Shader.Defines.emplace_back("__HLSL_ENABLE_16_BIT", "1"); // as DXC says it
		}
		else if (Word == "202x" && Words[i - 1] == "-HV")
		{
			Shader.Defines.emplace_back("__HLSL_VERSION", "202x");
		}
		else if (Word.starts_with("%t/"))
		{
			Shader.Text = FindPart(Parts, Word);
		}
		Shader.bRowMajor = Shader.bRowMajor || Word == "-Zpr";
	}
	if (Object.empty() || Shader.Text.empty())
	{
		throw FNotRead("a run line without a shader");
	}
	return {Object, Shader};
}

/** Makes defines of Vulkan's specialization constants, which Direct3D does not have. */
void DefineSpecialized(FRun& Run)
{
	static const std::regex Constant(R"(\[\[vk::constant_id\((\d+)\)\]\](\s*)const\s+(\w+)\s+(\w+)\s*=\s*([^;]+);)");
	for (std::smatch Found; std::regex_search(Run.Shader.Text, Found, Constant);)
	{
		const auto Told = Run.Pipeline.Specialized.find(Found[1]);
		const std::string Value = Told == Run.Pipeline.Specialized.end() ? Found[5].str() : Told->second;
		Run.Shader.Defines.emplace_back(Found[4], "((" + Found[3].str() + ")" + Value + ")");
		Run.Shader.Text = Found.prefix().str() + Found[2].str() + Found.suffix().str();
	}
}

} // namespace

FTest ReadTest(const std::string& Path)
{
	const FParts Parts = Split(Path);
	FTest Test;
	Test.WaveSize = Parts.WaveSize;
	if (Test.WaveSize > 64)
	{
		throw FNotRead("waves of " + std::to_string(Test.WaveSize) + " threads, more than a kernel has");
	}
	constexpr int32_t NumCompilers = 2;
	if (Parts.NumUnsupported == NumCompilers)
	{
		throw FNotRead("a test that the suite asks of no compiler");
	}
	std::map<std::string, FShaderSourceText> Objects;
	for (const std::string& Line : Parts.RunLines)
	{
		const std::vector<std::string> Words = GetWords(Line);
		if (Words.empty())
		{
			continue;
		}
		if (Words[0] == "not")
		{
			throw FNotRead("a test of what the suite's own tool refuses");
		}
		if (Words[0].starts_with("%dxc_target"))
		{
			const auto [Object, Shader] = ReadCompilation(Parts, Words);
			Objects[Object] = Shader;
		}
		if (Words[0] != "%offloader")
		{
			continue;
		}
		FRun Run;
		for (const std::string& Word : Words)
		{
			if (Word.ends_with(".yaml"))
			{
				Run.Pipeline = ReadPipeline(FindPart(Parts, Word));
			}
			if (const auto Found = Objects.find(Word); Found != Objects.end())
			{
				Run.Shader = Found->second;
			}
		}
		DefineSpecialized(Run);
		if (Run.Pipeline.HasCounters() || Run.Pipeline.Results.empty())
		{
			AddChecks(Parts.CheckLines, Run.Pipeline);
		}
		if (Run.Pipeline.Results.empty())
		{
			throw FNotRead("no expected values");
		}
		Test.Runs.push_back(std::move(Run));
	}
	if (Test.Runs.empty())
	{
		throw FNotRead("no run line of the suite's tool");
	}
	return Test;
}

} // namespace Drydock::Conformance
