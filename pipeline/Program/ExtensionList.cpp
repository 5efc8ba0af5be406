// Makes the tables of extensions, insertable passes and hooks.
#include "Program/ExtensionList.h"

#include "ExtensionFactory.h"
#include "Extensions/EngineHooks.h"
#include "PassFactory.h"
#include "Program/ProgramOutput.h"
#include "Run/Run.h"

namespace Drydock
{

namespace
{

std::string Join(const std::vector<std::string>& Names, const char* Separator)
{
	std::string Text;
	for (const std::string& Name : Names)
	{
		Text += (Text.empty() ? "" : Separator) + Name;
	}
	return Text;
}

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
	const std::string Instead = Hook.Instead[0] != '\0' ? "; override " + std::string(Hook.Instead) : "";
	const std::string Why = Hook.NeverHere != nullptr ? ": it " + std::string(Hook.NeverHere)
							: Hook.First > Hook.Last  ? ": no longer called"
													  : "";
	return Hook.Signature + (Why.empty() ? "" : Why + Instead);
}

} // namespace

FListTable ListExtensions()
{
	FListTable Table{{"type", "is", "name", "kind", "default", "range", "doc"}, {}};
	for (const FExtensionFactory* Factory : GetExtensionFactories())
	{
		Table.Rows.push_back({Factory->Type, "extension", "", "", "", "", Factory->Doc});
		if (!Factory->Passes.empty())
		{
			Table.Rows.push_back({Factory->Type, "parameter", "pass", "hook", Factory->Passes[0], "",
				"Where it is called: " + Join(Factory->Passes, ", ") + "."});
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

FListTable ListHooks()
{
	FListTable Table{{"point", "since", "sees", "doc"}, {}};
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
	FListTable Table{{"point", "sees", "texture", "format", "size", "subscribers", "called", "remark"}, {}};
	if (bViews)
	{
		Table.Header.insert(Table.Header.begin() + 1, "view");
	}
	for (const FHookPoint& Point : Result.HookPoints)
	{
		const std::string Size =
			Point.Resource.empty() ? "" : std::to_string(Point.Width) + "x" + std::to_string(Point.Height);
		std::vector<std::string> Row = {Point.Point, Point.Space, Point.Resource, Point.Format, Size,
			Join(Point.Subscribers, ", "), Point.bCalled ? "yes" : "no", Point.Reason};
		if (bViews)
		{
			Row.insert(Row.begin() + 1, Point.View);
		}
		Table.Rows.push_back(std::move(Row));
	}
	return Table;
}

} // namespace Drydock
