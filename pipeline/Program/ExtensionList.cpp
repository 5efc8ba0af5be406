// Makes the tables of extensions, insertable passes and hooks.
#include "Program/ExtensionList.h"

#include "ExtensionFactory.h"
#include "Extensions/EngineHooks.h"
#include "PassFactory.h"
#include "Program/ProgramOutput.h"
#include "Run/Explain.h"
#include "Run/PassValues.h"
#include "Run/Run.h"
#include "TextTools.h"
#include "RangeTools.h"

namespace Drydock
{

namespace
{

void AddParameters(const std::string& Type, const std::vector<FParameterSpec>& Parameters, FListTable& Table)
{
	for (const FParameterSpec& Spec : Parameters)
	{
		Table.Rows.push_back(
			{Type, "parameter", Spec.Name, ToString(Spec.Kind), ToText(Spec.Default), GetRangeText(Spec), Spec.Doc});
	}
}

/** "5.1", "5.1 to 5.4", "never". */
std::string DescribeVersions(const FHookVersions& Hook)
{
	if (Hook.First > Hook.Last)
	{
		return "never";
	}
	const bool bStill = Hook.Last == GetEngineProfiles().back().Minor;
	return GetEngineVersionText(Hook.First) + (bStill ? "" : " to " + GetEngineVersionText(Hook.Last));
}

std::string DescribeHook(const FHookVersions& Hook)
{
	const std::string Instead = Hook.Instead.empty() ? "" : "; override " + Hook.Instead;
	const std::string Why = !Hook.NeverHere.empty()  ? ": it " + Hook.NeverHere
							: Hook.First > Hook.Last ? ": no longer called"
													 : "";
	return Hook.Signature + (Why.empty() ? "" : Why + Instead);
}

} // namespace

FListTable ListExtensions()
{
	FListTable Table{{"type", "is", "name", "kind", "default", "range", "doc"}, {}, "",
		{{ETextColumn::Name}, {}, {ETextColumn::Name}, {ETextColumn::Text, 3}, {ETextColumn::Text, 1},
			{ETextColumn::Text, 2}, {}}};
	for (const FExtensionFactory* Factory : GetExtensionFactories())
	{
		Table.Rows.push_back({Factory->Type, "extension", "", "", "", "", Factory->Doc});
		if (!Factory->Passes.empty())
		{
			Table.Rows.push_back({Factory->Type, "parameter", "pass", "hook", Factory->Passes[0], "",
				"Called at: " + JoinText(Factory->Passes) + "."});
		}
		AddParameters(Factory->Type, Factory->Parameters, Table);
	}
	for (const FPassFactory* Factory : GetPassFactories())
	{
		Table.Rows.push_back({Factory->Type, "pass", "", "", "", "", Factory->Doc});
		for (const FPassInputSpec& Input : Factory->Inputs)
		{
			Table.Rows.push_back({Factory->Type, "input", Input.Name, "resource", Input.Default, "", Input.Doc});
		}
		AddParameters(Factory->Type, Factory->Parameters, Table);
	}
	return Table;
}

FListTable ListPasses()
{
	FListTable Table{{"pass", "reads", "parameters", "what it does"}, {}, "", {{ETextColumn::Name}, {}, {}, {}}};
	for (const FPassFactory* Factory : GetPassFactories())
	{
		auto Inputs = ToVector<std::string>(Factory->Inputs, [&](const FPassInputSpec& Input)
			{ return Input.Name + (Input.Default.empty() ? " (to be given)" : " = " + Input.Default); });
		std::vector<std::string> Parameters;
		for (const FParameterSpec& Spec : Factory->Parameters)
		{
			const std::string Range = GetRangeText(Spec);
			Parameters.push_back(Spec.Name + " = " + ToText(Spec.Default) + (Range.empty() ? "" : " (" + Range + ")"));
		}
		Table.Rows.push_back({Factory->Type, JoinText(Inputs), JoinText(Parameters), Factory->Doc});
	}
	return Table;
}

FListTable ListPasses(const FRunOptions& Options)
{
	FRunOptions Compiled = Options;
	Compiled.bExecute = false;
	Compiled.bPassValues = true;
	const FRunResult Result = RunConfig(Compiled);
	PrintDiagnostics(Result.Diagnostics);
	FListTable Table{{"pass", "of", "runs", "reads", "writes", "parameters"}, {}, "",
		{{ETextColumn::Name}, {ETextColumn::Name, 2}, {}, {}, {}, {ETextColumn::Text, 1}}};
	for (const FExplainedPass& Pass : MakeExplainReport(Result, Result, FCostModel()).Passes)
	{
		Table.Rows.push_back({Pass.Name, Pass.Effect, Pass.bExecutes ? "yes" : "no", JoinText(Pass.Reads),
			JoinText(Pass.Writes), FormatPassValues(Pass.Values)});
	}
	return Table;
}

FListTable ListHooks()
{
	FListTable Table{{"point", "since", "sees", "doc"}, {}, "", {{ETextColumn::Name}, {}, {ETextColumn::Text, 1}, {}}};
	Table.Rows.push_back({PrePostProcessPassName, GetEngineProfiles().front().GetVersion(),
		ToString(EColorSpace::LinearHDR), "before the chain: scene colour, edited in place"});
	for (const FInsertionPoint& Point : GetInsertionPoints())
	{
		Table.Rows.push_back(
			{GetPassName(Point.Pass), GetEngineVersionText(Point.First), ToString(Point.Space), Point.Doc});
	}
	for (const FHookVersions& Hook : GetHookVersions())
	{
		Table.Rows.push_back({GetHookName(Hook.Hook), DescribeVersions(Hook), "hook", DescribeHook(Hook)});
	}
	return Table;
}

FListTable ListHooks(const FRunOptions& Options)
{
	FRunOptions Compiled = Options;
	Compiled.bExecute = false;
	const FRunResult Result = RunConfig(Compiled);
	PrintDiagnostics(Result.Diagnostics);
	const bool bViews = Result.Views.size() > 1;
	FListTable Table{{"point", "sees", "texture", "format", "size", "subscribers", "called", "remark"}, {}, "",
		{{ETextColumn::Name}, {ETextColumn::Text, 2}, {ETextColumn::Name}, {ETextColumn::Name, 1},
			{ETextColumn::Name, 3}, {}, {}, {}}};
	if (bViews)
	{
		Table.Header.insert(Table.Header.begin() + 1, "view");
		Table.Columns.insert(Table.Columns.begin() + 1, FTextColumn{});
	}
	for (const FHookPoint& Point : Result.HookPoints)
	{
		const std::string Size =
			Point.Resource.empty() ? "" : std::to_string(Point.Width) + "x" + std::to_string(Point.Height);
		std::vector<std::string> Row = {Point.Point, Point.Space, Point.Resource, Point.Format, Size,
			JoinText(Point.Subscribers), Point.bCalled ? "yes" : "no", Point.Reason};
		if (bViews)
		{
			Row.insert(Row.begin() + 1, Point.View);
		}
		Table.Rows.push_back(std::move(Row));
	}
	return Table;
}

} // namespace Drydock
