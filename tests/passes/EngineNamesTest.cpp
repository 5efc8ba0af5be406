// No name of drydock's own stands below /Engine: what the shipped shaders define there is in EngineNames.txt, and what
// the table has is there.
#include <gtest/gtest.h>

#include "EngineNames.h"
#include "InstallPaths.h"
#include "ShaderCompilation.h"
#include "ShaderDirectories.h"
#include "ShaderSource.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

namespace
{

using namespace Drydock;
namespace fs = std::filesystem;

/** The macros that a file defines and does not take back. */
std::set<std::string> ListMacros(const std::string& Path)
{
	std::ifstream File(FindShaderFile(Path));
	const std::string Text(std::istreambuf_iterator<char>(File), {});
	std::set<std::string> Macros;
	const std::regex Directive(R"(#[ \t]*(define|undef)[ \t]+(\w+))");
	for (std::sregex_iterator It(Text.begin(), Text.end(), Directive), End; It != End; ++It)
	{
		if ((*It)[1] == "define")
		{
			Macros.insert((*It)[2]);
		}
		else
		{
			Macros.erase((*It)[2]);
		}
	}
	return Macros;
}

/** Names at file scope by the file that defines them, of a file and all that it includes. */
std::map<std::string, std::set<std::string>> ListNames(const std::string& Path)
{
	std::map<std::string, std::set<std::string>> Names;
	for (const EShaderStage Stage : {EShaderStage::Compute, EShaderStage::Pixel})
	{
		const FHlslText Text(FlattenShader(MakeShaderCompileRequest(Path, "", Stage)).Text, Path);
		for (const size_t At : ListDefinitions(Text))
		{
			Names[Text.Files[Text[At].File]].insert(Text[At].Text);
		}
		for (const std::string& File : Text.Files)
		{
			Names[File].merge(ListMacros(File));
		}
	}
	Names[Path].merge(ListMacros(Path));
	Names[Path].insert(fs::path(Path).filename().string());
	return Names;
}

/** Virtual paths of the shipped files below /Engine. */
std::set<std::string> ListEngineFiles()
{
	std::set<std::string> Files;
	const std::string Root = FindShippedShaders();
	for (const auto& [Virtual, Real] : {std::pair("/Engine/", Root + "/rdg/graph/Shaders/Engine"),
			 std::pair("/Engine/Private/", Root + "/passes/Shaders")})
	{
		for (const fs::directory_entry& Entry : fs::recursive_directory_iterator(Real))
		{
			const std::string Relative = Entry.path().lexically_relative(Real).generic_string();
			if (Entry.is_regular_file() && !Relative.starts_with("Drydock/")) // mapped to /Drydock/Private
			{
				Files.insert(Virtual + Relative);
			}
		}
	}
	return Files;
}

} // namespace

TEST(EngineNames, EveryNameBelowEngineIsInTheTable)
{
	MakeShaderCompileRequest("", "", EShaderStage::Compute); // maps the shipped shaders
	std::map<std::string, std::set<std::string>> Rows;
	for (const FEngineName& Row : GetEngineNames())
	{
		Rows[Row.Certainty == "drydock" ? "" : Row.IsFile() ? Row.File : "names"].insert(Row.Name);
	}
	const std::set<std::string> Files = ListEngineFiles();
	EXPECT_LT(40u, Files.size());
	for (const std::string& File : Files)
	{
		EXPECT_TRUE(Rows.contains(File)) << File << ": it belongs below /Drydock, or needs a row";
		const std::set<std::string> Names = ListNames(File)[File];
		for (const std::string& Name : Names)
		{
			// What a .usf defines beside its rows stays in it: the lint reports who uses it.
			EXPECT_TRUE(File.ends_with(".usf") || Rows["names"].contains(Name) || File.ends_with("/" + Name))
				<< File << " defines " << Name << ": it belongs below /Drydock, or needs a row";
			EXPECT_FALSE(Rows[""].contains(Name)) << File << " defines " << Name << ", which is drydock's own";
		}
	}
}

TEST(EngineNames, EveryRowIsThere)
{
	MakeShaderCompileRequest("", "", EShaderStage::Compute);
	std::map<std::string, std::set<std::string>> ByFile;
	std::set<std::pair<std::string, std::string>> Seen;
	for (const FEngineName& Row : GetEngineNames())
	{
		SCOPED_TRACE(Row.Name + " of " + Row.File);
		EXPECT_TRUE(Seen.emplace(Row.Name, Row.File).second) << "twice";
		EXPECT_TRUE(std::set<std::string>({"public", "uncertain", "article", "drydock"}).contains(Row.Certainty))
			<< Row.Certainty;
		EXPECT_TRUE(Row.File.starts_with(Row.Certainty == "drydock" ? "/Drydock/" : "/Engine/"));
		for (const std::string& Version : {Row.From, Row.Until})
		{
			EXPECT_TRUE(std::regex_match(Version, std::regex("-|[45]\\.[0-9]+"))) << Version;
		}
		EXPECT_FALSE(Row.Deprecated.empty());
		ASSERT_FALSE(FindShaderFile(Row.File).empty());
		if (!ByFile.contains(Row.File))
		{
			for (const auto& [File, Names] : ListNames(Row.File))
			{
				ByFile[Row.File].insert(Names.begin(), Names.end());
			}
		}
		EXPECT_TRUE(ByFile[Row.File].contains(Row.Name)) << "the file does not give it";
	}
}

TEST(EngineNames, WhatAFileTakesBackIsNoNameOfIts)
{
	const std::set<std::string> Names = ListNames("/Engine/Private/Common.ush")["/Engine/Private/Common.ush"];
	EXPECT_TRUE(Names.contains("Pow3"));        // made by a macro
	EXPECT_TRUE(Names.contains("PI"));          // a constant
	EXPECT_TRUE(Names.contains("PrimaryView")); // a macro
	EXPECT_TRUE(Names.contains("FScreenVertexOutput"));
	EXPECT_FALSE(Names.contains("DRYDOCK_POWERS"));
	EXPECT_FALSE(Names.contains("InterleavedGradientNoise")); // of an included file
}
