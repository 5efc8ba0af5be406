// Runs a pass that a config could insert, by its name.
#pragma once

#include "PassTestUtils.h"

#include "PassFactory.h"

#include <map>
#include <string>

namespace PassTest
{

/** Values: beside the defaults. Second: name of a second input, which is the image too; empty where there is none. */
inline FImage RunFactory(const std::string& Type, const FImage& Image,
	const std::map<std::string, Drydock::FParameterValue>& Values = {}, const std::string& Second = "")
{
	const Drydock::FPassFactory* const Factory = Drydock::FindPassFactory(Type);
	EXPECT_NE(nullptr, Factory) << Type;
	if (Factory == nullptr)
	{
		return FImage();
	}
	FPassRun Run(Image, EArithmetic::Float32, PF_A32B32G32R32F);
	Drydock::FPassArguments Arguments;
	Arguments.Values = Drydock::FParameterValues(Factory->Parameters);
	for (const auto& [Name, Value] : Values)
	{
		Arguments.Values.Set(Name, Value);
	}
	Arguments.Inputs["Input"] = Run.Input;
	if (!Second.empty())
	{
		Arguments.Inputs[Second] = Run.Input;
	}
	return Run.Execute(Factory->Add(Run.GraphBuilder, Run.View, Arguments));
}

} // namespace PassTest
