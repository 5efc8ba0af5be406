// Writes run.json, timing.json and trace.json.
#include "Run/RunJson.h"
#include "LanesScalarCalls.h"

#include "PostProcessSettingsReflection.h"
#include "Run/RunDump.h"
#include "Text/JsonWriter.h"
#include "Text/TextFormat.h"
#include "Text/Version.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace Drydock
{

namespace
{

/** Passes run in the order of their indices. */
const FRunPass* FindRunPass(const FRunResult& Result, int Index)
{
	const auto Found = std::lower_bound(Result.Passes.begin(), Result.Passes.end(), Index,
		[](const FRunPass& Pass, int Wanted) { return Pass.Index < Wanted; });
	return Found == Result.Passes.end() || Found->Index != Index ? nullptr : &*Found;
}

void WriteSettings(FJsonWriter& Writer, const FRunResult& Result)
{
	Writer.Key("settings").BeginObject();
	for (const FSettingField& Field : GetSettingFields())
	{
		Writer.Key(Field.Name).Raw(SettingToJson(Field, Field.Get(Result.Settings)));
	}
	Writer.EndObject();
}

/** The record by which a run is repeated and compared. */
void WriteInputs(FJsonWriter& Writer, const FRunResult& Result)
{
	Writer.Member("arguments", Result.Arguments);
	Writer.Object("inputs", Result.Inputs, [&](const auto& Input) { Writer.Member(Input.first, Input.second); });
	Writer.Array("variables", Result.Variables,
		[&](const FRunVariable& Variable) {
			Writer.Object({{"name", Variable.Name}, {"value", Variable.Value}, {"setBy", Variable.SetBy}});
		});
	if (Result.bHistory)
	{
		Writer.Member("history", true);
	}
}

void WriteEffects(
	FJsonWriter& Writer, const std::vector<FEffectDecision>& Effects, const FFiguresByEffect& FiguresByEffect)
{
	Writer.Objects("effects", Effects,
		[&](const FEffectDecision& Effect)
		{
			Writer.Members({{"name", Effect.GetName()}, {"active", Effect.bActive}, {"reason", Effect.Reason}});
			const auto Figures = FiguresByEffect.find(Effect.GetId());
			if (Figures != FiguresByEffect.end())
			{
				for (const FFigureGroup& Group : Figures->second.Groups)
				{
					Writer.Object(Group.Name, Group.Figures,
						[&](const FFigure& Figure) {
							std::visit(
								[&](const auto& Value) { Writer.Member(Figure.Name.c_str(), Value); }, Figure.Value);
						});
				}
			}
		});
}

void WriteHookCalls(FJsonWriter& Writer, const FRunResult& Result)
{
	Writer.Array("extensionCalls", Result.HookCalls,
		[&](const FHookCall& Call) {
			Writer.Object({{"hook", Call.Hook}, {"view", Call.View}, {"extension", Call.Extension}, {"did", Call.Did}});
		});
}

void WritePasses(FJsonWriter& Writer, const FRunResult& Result)
{
	Writer.Array("passes", Result.Graph.Passes,
		[&](const FRDGCompiledPass& Pass)
		{
			if (Pass.bIsSentinel)
			{
				return;
			}
			const FRunPass* Run = FindRunPass(Result, Pass.Index);
			const FPassCounters Counters = Run != nullptr ? Run->Counters : FPassCounters();
			Writer.BeginObject(true);
			Writer.Members({{"index", Pass.Index}, {"name", Pass.Name}, {"executed", Run != nullptr},
				{"reason", Result.Graph.DescribeCulled(Pass)},
				{"shader", Pass.Shader.empty() ? Counters.Shader : Pass.Shader},
				{"entry", Pass.Entry.empty() ? Counters.Entry : Pass.Entry},
				{"runsAs", Run != nullptr ? DescribeShaderRun(Counters.Ran) : Pass.RunsAs}, {"pixels", Counters.Pixels},
				{"taps", Run != nullptr ? Run->Taps : std::optional<uint64_t>(0)}, {"bytesRead", Counters.BytesRead},
				{"bytesWritten", Counters.BytesWritten}});
			if (Run != nullptr && !Run->SameAs.empty())
			{
				Writer.Members({{"sameAs", Run->SameAs}, {"because", Run->SameBecause}});
			}
			if (Run != nullptr && !Run->Written.empty())
			{
				Writer.Key("written").BeginObject();
				for (const FRunFingerprint& Texture : Run->Written)
				{
					Writer.Member(Texture.Resource, Texture.Fingerprint);
				}
				Writer.EndObject();
			}
			Writer.EndObject();
		});
}

void WriteOutputs(FJsonWriter& Writer, const FRunResult& Result)
{
	Writer.Key("outputs").BeginObject();
	const auto MemberIf = [&](EOutputKind Kind, const char* Name, const char* File)
	{
		if (Result.Write.count(Kind) > 0)
		{
			Writer.Member(Name, File);
		}
	};
	MemberIf(EOutputKind::Png, "final", "final.png");
	MemberIf(EOutputKind::Exr, "finalExr", "final.exr");
	MemberIf(EOutputKind::Exr, "sceneLinear", "scene_linear.exr");
	MemberIf(EOutputKind::Json, "timing", "timing.json");
	MemberIf(EOutputKind::Dot, "graph", "graph.dot");
	MemberIf(EOutputKind::Json, "trace", "trace.json");
	for (const auto& [Id, Figures] : Result.Figures)
	{
		for (const FEffectPicture& Picture : Figures.Pictures)
		{
			MemberIf(EOutputKind::Png, Picture.Name.c_str(), (Picture.File + ".png").c_str());
		}
	}
	const char* const Extension = Result.Write.count(EOutputKind::Exr) > 0   ? ".exr"
								  : Result.Write.count(EOutputKind::Png) > 0 ? ".png"
																			 : nullptr;
	Writer.Key("passes").BeginArray();
	for (size_t Index = 0; Extension != nullptr && Index < Result.Dumps.size(); ++Index)
	{
		Writer.Value("passes/" + GetDumpFileName(Result.Dumps[Index]) + Extension);
	}
	Writer.EndArray();
	Writer.EndObject();
}

void WriteWarnings(FJsonWriter& Writer, const FRunResult& Result)
{
	Writer.Array("warnings", Result.Diagnostics,
		[&](const FDiagnostic& Diagnostic)
		{
			std::string Where = Diagnostic.File;
			if (Diagnostic.Line > 0)
			{
				Where += ":" + std::to_string(Diagnostic.Line) + ":" + std::to_string(Diagnostic.Column);
			}
			Where += (Where.empty() || Diagnostic.Where.empty() ? "" : " ") + Diagnostic.Where;
			Writer.Object({{"severity", Diagnostic.Severity == ESeverity::Note ? "note" : "warning"},
				{"code", FormatCode(Diagnostic.Code)}, {"message", Diagnostic.Message}, {"where", Where}});
		});
}

std::array<int32, 4> ListCorners(const FIntRect& Rect)
{
	return {Rect.Min.X, Rect.Min.Y, Rect.Max.X, Rect.Max.Y};
}

/** Writes the result of "auto"; nothing for a number. */
void WriteExposure(FJsonWriter& Writer, const std::optional<FExposureReport>& Exposure)
{
	if (!Exposure)
	{
		return;
	}
	Writer.Members({{"method", Exposure->Method}, {"targetScale", Exposure->TargetScale},
		{"averageLuminance", Exposure->AverageLuminance}, {"ev100", Exposure->EV100},
		{"compensation", Exposure->Compensation}, {"averageLocalExposure", Exposure->AverageLocalExposure}});
	if (Exposure->Histogram)
	{
		Writer.Key("histogram").BeginObject();
		Writer.Members({{"logMin", Exposure->Histogram->LogMin}, {"logMax", Exposure->Histogram->LogMax},
			{"lowPercent", Exposure->Histogram->LowPercent}, {"highPercent", Exposure->Histogram->HighPercent},
			{"buckets", Exposure->Histogram->Buckets}});
		Writer.EndObject();
	}
}

/** Writes several views; the settings and effects of the whole run are those of the first view. */
void WriteViews(FJsonWriter& Writer, const FRunResult& Result)
{
	if (Result.Views.size() <= 1)
	{
		return;
	}
	Writer.Array("views", Result.Views,
		[&](const FRunView& View)
		{
			Writer.BeginObject();
			Writer.Members(
				{{"name", View.Name}, {"rect", ListCorners(View.Rect)}, {"exposureScale", View.ExposureScale}});
			if (View.Exposure)
			{
				Writer.Key("exposure").BeginObject();
				WriteExposure(Writer, View.Exposure);
				Writer.EndObject();
			}
			WriteEffects(Writer, View.Effects, View.Figures);
			Writer.EndObject();
		});
}

} // namespace

std::string GetCpuName()
{
	std::ifstream Info("/proc/cpuinfo");
	for (std::string Line; std::getline(Info, Line);)
	{
		const size_t Colon = Line.find(": ");
		if (Line.starts_with("model name") && Colon != std::string::npos)
		{
			return Line.substr(Colon + 2);
		}
	}
	return "";
}

std::string MakeRunJson(const FRunResult& Result)
{
	FJsonWriter Writer('{');
	Writer.Members({{"version", GetVersion()}, {"commit", GetCommit()},
		{"config", std::filesystem::path(Result.Config.File).filename().string()},
		{"engine", Result.Config.Engine.Value}, {"precision", Result.Precision}});
	Writer.MemberIfAny("device", Result.Device);
	Writer.Member("storage", Result.Storage);
	Writer.MemberIfAny("budget", Result.BudgetReason);
	Writer.Key("scene").BeginObject();
	Writer.Members({{"file", Result.Config.Scene.File.Value},
		{"extent", std::array{Result.SceneExtent.X, Result.SceneExtent.Y}}, {"viewRect", ListCorners(Result.ViewRect)},
		{"lightColor", std::array{Result.LightColor.R, Result.LightColor.G, Result.LightColor.B}}});
	Writer.EndObject();
	Writer.Key("exposure").BeginObject(!Result.Exposure.has_value());
	Writer.Members({{"scale", Result.ExposureScale}, {"preExposure", Result.Config.View.PreExposure.Value}});
	WriteExposure(Writer, Result.Exposure);
	Writer.EndObject();
	WriteInputs(Writer, Result);
	WriteSettings(Writer, Result);
	WriteEffects(Writer, Result.Effects, Result.Figures);
	WriteViews(Writer, Result);
	WriteHookCalls(Writer, Result);
	WritePasses(Writer, Result);
	Writer.Key("memory").Object({{"transientPeakBytes", Result.Graph.Memory.TransientPeakBytes},
		{"withoutAliasingBytes", Result.Graph.Memory.WithoutAliasingBytes}});
	Writer.Array("channels", Result.Channels,
		[&](const FSceneChannel& Channel) {
			Writer.Object({{"name", Channel.Name}, {"decoded", Channel.bDecoded}});
		});
	WriteOutputs(Writer, Result);
	WriteWarnings(Writer, Result);
	return Writer.GetText();
}

std::string MakeTimingJson(const FRunResult& Result, double SaveMs, const std::string& ConfigPath)
{
	FJsonWriter Writer('{');
	Writer.MemberIfAny("config", ConfigPath);
	Writer.Members({{"threads", Result.Threads}, {"cpu", GetCpuName()}});
	Writer.Array("passes", Result.Passes,
		[&](const FRunPass& Pass)
		{
			Writer.Object({{"index", Pass.Index}, {"name", Result.Graph.Passes[static_cast<size_t>(Pass.Index)].Name},
				{"ms", Pass.Milliseconds}, {"taps", Pass.Taps}, {"runsAs", DescribeShaderRun(Pass.Counters.Ran)},
				{"reused", Pass.IsReused()}});
		});
	Writer.Members({{"startMs", Result.Times.Start}, {"setupMs", Result.Times.Setup}, {"loadMs", Result.Times.Load},
		{"compileMs", Result.Times.Compile}, {"executeMs", Result.Times.Execute}, {"reportMs", Result.Times.Report},
		{"saveMs", SaveMs}});
	const std::chrono::duration<double, std::milli> Wall = std::chrono::steady_clock::now() - Result.Times.Begin;
	Writer.Member("wallMs", Result.Times.Start + Wall.count());
	// Counts for the process: packs of lanes whose texels were read or written one by one.
	Writer.Key("scalarCalls").BeginObject(true);
	for (uint8_t Index = 0; Index < uint8_t(EScalarCall::Count); ++Index)
	{
		Writer.Member(GetScalarCallName(EScalarCall(Index)), GetScalarCalls(EScalarCall(Index)));
	}
	return Writer.GetText();
}

std::string MakeTraceJson(const FRunResult& Result)
{
	FJsonWriter Writer;
	double Now = 0.0;
	const auto Event =
		[&](const std::string& Name, const std::string& Category, double Milliseconds, const FRunPass* Pass)
	{
		Writer.BeginObject(true);
		Writer.Members({{"name", Name}, {"cat", Category}, {"ph", "X"}, {"ts", Now * 1000.0},
			{"dur", Milliseconds * 1000.0}, {"pid", 1}, {"tid", 1}});
		Writer.Key("args").BeginObject();
		if (Pass != nullptr)
		{
			Writer.Members({{"shader", Pass->Counters.Shader}, {"runsAs", DescribeShaderRun(Pass->Counters.Ran)},
				{"pixels", Pass->Counters.Pixels}, {"taps", Pass->Taps}});
		}
		Writer.EndObject();
		Writer.EndObject();
		Now += Milliseconds;
	};
	Writer.BeginObject();
	Writer.Key("traceEvents").BeginArray();
	Event("Build and compile graph", "graph", Result.Times.Compile, nullptr);
	Event("Load scene", "scene", Result.Times.Load, nullptr);
	for (const FRunPass& Pass : Result.Passes)
	{
		Event(Result.Graph.Passes[static_cast<size_t>(Pass.Index)].Name, "pass", Pass.Milliseconds, &Pass);
	}
	return Writer.GetText();
}

} // namespace Drydock
