// Values of parameters by name, and the text that lists the values allowed.
#include "FactoryParameters.h"

#include "Math/ToInteger.h"
#include "TextTools.h"

#include <cmath>

namespace Drydock
{

FParameterSpec FParameterSpec::Number(std::string Name, double Default, double Min, double Max, std::string Doc)
{
	return {std::move(Name), EParameterKind::Number, Default, Min, Max, {}, std::move(Doc)};
}

FParameterSpec FParameterSpec::Integer(std::string Name, int32 Default, int32 Min, int32 Max, std::string Doc)
{
	return {std::move(Name), EParameterKind::Integer, static_cast<double>(Default), static_cast<double>(Min),
		static_cast<double>(Max), {}, std::move(Doc)};
}

FParameterSpec FParameterSpec::Bool(std::string Name, bool bDefault, std::string Doc)
{
	FParameterSpec Spec;
	Spec.Name = std::move(Name);
	Spec.Kind = EParameterKind::Bool;
	Spec.Default = bDefault;
	Spec.Doc = std::move(Doc);
	return Spec;
}

FParameterSpec FParameterSpec::Text(
	std::string Name, std::string Default, std::vector<std::string> Choices, std::string Doc)
{
	FParameterSpec Spec;
	Spec.Name = std::move(Name);
	Spec.Kind = EParameterKind::Text;
	Spec.Default = std::move(Default);
	Spec.Choices = std::move(Choices);
	Spec.Doc = std::move(Doc);
	return Spec;
}

FParameterSpec FParameterSpec::Color(std::string Name, const FLinearColor& Default, std::string Doc)
{
	FParameterSpec Spec;
	Spec.Name = std::move(Name);
	Spec.Kind = EParameterKind::Color;
	Spec.Default = Default;
	Spec.Doc = std::move(Doc);
	return Spec;
}

FParameterValues::FParameterValues(const std::vector<FParameterSpec>& Specs)
{
	for (const FParameterSpec& Spec : Specs)
	{
		Values[Spec.Name] = Spec.Default;
	}
}

template<typename T>
const T& FParameterValues::Get(const std::string& Name) const
{
	const auto Found = Values.find(Name);
	checkf(Found != Values.end() && std::holds_alternative<T>(Found->second),
		TEXT("There is no parameter %s of that type"), Name.c_str());
	return std::get<T>(Found->second);
}

double FParameterValues::GetNumber(const std::string& Name) const
{
	return Get<double>(Name);
}

float FParameterValues::GetFloat(const std::string& Name) const
{
	return static_cast<float>(Get<double>(Name));
}

int32 FParameterValues::GetInteger(const std::string& Name) const
{
	return ToInteger<int32>(Get<double>(Name));
}

bool FParameterValues::GetBool(const std::string& Name) const
{
	return Get<bool>(Name);
}

const std::string& FParameterValues::GetText(const std::string& Name) const
{
	return Get<std::string>(Name);
}

FLinearColor FParameterValues::GetColor(const std::string& Name) const
{
	return Get<FLinearColor>(Name);
}

const char* ToString(EParameterKind Kind)
{
	static const char* const Names[] = {"number", "integer", "bool", "text", "color"};
	return Names[static_cast<int>(Kind)];
}

std::string ToText(const FParameterValue& Value)
{
	struct FWriter
	{
		std::string operator()(double Number) const { return FormatShortest(Number); }
		std::string operator()(bool bTrue) const { return bTrue ? "true" : "false"; }
		std::string operator()(const std::string& Text) const { return "\"" + Text + "\""; }
		std::string operator()(const FLinearColor& Color) const
		{
			return "[" + FormatShortest(Color.R) + ", " + FormatShortest(Color.G) + ", " + FormatShortest(Color.B) +
				   ", " + FormatShortest(Color.A) + "]";
		}
	};
	return std::visit(FWriter(), Value);
}

std::string GetRangeText(const FParameterSpec& Spec)
{
	std::string Text = JoinText(Spec.Choices, "|");
	if (std::isfinite(Spec.Min))
	{
		Text = std::isfinite(Spec.Max) ? FormatShortest(Spec.Min) + " .. " + FormatShortest(Spec.Max)
									   : ">= " + FormatShortest(Spec.Min);
	}
	else if (std::isfinite(Spec.Max))
	{
		Text = "<= " + FormatShortest(Spec.Max);
	}
	return Text;
}

} // namespace Drydock
