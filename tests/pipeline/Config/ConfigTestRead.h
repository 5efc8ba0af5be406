// Reads a config's text in a test: what was read, and its messages in short.
#pragma once

#include <gtest/gtest.h>

#include "Config/ReadConfig.h"

#include <string>
#include <vector>

namespace ConfigTest
{

using namespace Drydock;

struct FRead
{
	FConfig Config;
	std::vector<FDiagnostic> Diagnostics;
};

inline FRead Read(const std::string& Text)
{
	FRead Result;
	Result.Config = ReadConfig(Text, "configs/a.json", Result.Diagnostics);
	return Result;
}

inline FRead ReadClean(const std::string& Text)
{
	const FRead Result = Read(Text);
	EXPECT_TRUE(Result.Diagnostics.empty()) << Result.Diagnostics[0].ToString();
	return Result;
}

/** "code severity line:column pointer" of every message, and their texts. */
inline std::string Summary(const FDiagnostic& Diagnostic)
{
	return std::to_string(Diagnostic.Code) + (Diagnostic.Severity == ESeverity::Error ? " error " : " warning ") +
		   std::to_string(Diagnostic.Line) + ":" + std::to_string(Diagnostic.Column) + " " + Diagnostic.Where;
}

inline std::string Only(const std::string& Text)
{
	const FRead Result = Read(Text);
	EXPECT_EQ(1u, Result.Diagnostics.size()) << Text;
	return Result.Diagnostics.empty() ? "" : Summary(Result.Diagnostics[0]);
}

inline std::string OnlyText(const std::string& Text)
{
	const FRead Result = Read(Text);
	EXPECT_EQ(1u, Result.Diagnostics.size()) << Text;
	return Result.Diagnostics.empty() ? "" : Result.Diagnostics[0].Message;
}

/** A config with one unbound volume of these settings. The first one's key begins in column 46. */
inline std::string Volume(const std::string& Settings)
{
	return R"({"volumes": [{"bUnbound": true, "Settings": {)" + Settings + "}}]}";
}

inline const FPostProcessSettings& SettingsOf(const FRead& Result)
{
	return Result.Config.Volumes.at(0).Settings.Settings;
}

} // namespace ConfigTest
