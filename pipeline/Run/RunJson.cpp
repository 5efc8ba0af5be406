// Writes run.json, timing.json and trace.json.
#include "Run/RunJson.h"
#include "LanesScalarCalls.h"

#include "PostProcessSettingsReflection.h"
#include "Run/RunDump.h"
#include "Text/JsonWriter.h"
#include "Text/TextFormat.h"
#include "Text/Version.h"

#include <algorithm>
#include <cstdio>
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

void WriteFigure(FJsonWriter& Writer, const FFigure& Figure)
{
	if (const double* const Number = std::get_if<double>(&Figure.Value))
	{
		Writer.Member(Figure.Name.c_str(), *Number);
	}
	else if (const uint64_t* const Count = std::get_if<uint64_t>(&Figure.Value))
	{
		Writer.Member(Figure.Name.c_str(), *Count);
	}
	else
	{
		Writer.Key(Figure.Name.c_str()).BeginArray(true);
		for (const uint64_t Count : std::get<std::vector<uint64_t>>(Figure.Value))
		{
			Writer.Value(Count);
		}
		Writer.EndArray();
	}
}

void WriteEffects(
	FJsonWriter& Writer, const std::vector<FEffectDecision>& Effects, const FFiguresByEffect& FiguresByEffect)
{
	Writer.Key("effects").BeginArray();
	for (const FEffectDecision& Effect : Effects)
	{
		Writer.BeginObject(true);
		Writer.Member("name", Effect.GetName());
		Writer.Member("active", Effect.bActive);
		Writer.Member("reason", Effect.Reason);
		const auto Figures = FiguresByEffect.find(Effect.GetId());
		if (Figures != FiguresByEffect.end())
		{
			for (const FFigureGroup& Group : Figures->second.Groups)
			{
				Writer.Key(Group.Name.c_str()).BeginObject(true);
				for (const FFigure& Figure : Group.Figures)
				{
					WriteFigure(Writer, Figure);
				}
				Writer.EndObject();
			}
		}
		Writer.EndObject();
	}
	Writer.EndArray();
}

void WriteHookCalls(FJsonWriter& Writer, const FRunResult& Result)
{
	Writer.Key("extensionCalls").BeginArray();
	for (const FHookCall& Call : Result.HookCalls)
	{
		Writer.BeginObject(true);
		Writer.Member("hook", Call.Hook);
		Writer.Member("view", Call.View);
		Writer.Member("extension", Call.Extension);
		Writer.Member("did", Call.Did);
		Writer.EndObject();
	}
	Writer.EndArray();
}

void WritePasses(FJsonWriter& Writer, const FRunResult& Result)
{
	Writer.Key("passes").BeginArray();
	for (const FRDGCompiledPass& Pass : Result.Graph.Passes)
	{
		if (Pass.bIsSentinel)
		{
			continue;
		}
		const FRunPass* Run = FindRunPass(Result, Pass.Index);
		const FPassCounters Counters = Run != nullptr ? Run->Counters : FPassCounters();
		Writer.BeginObject(true);
		Writer.Member("index", Pass.Index);
		Writer.Member("name", Pass.Name);
		Writer.Member("executed", Run != nullptr);
		Writer.Member("reason", Result.Graph.DescribeCulled(Pass));
		Writer.Member("shader", Pass.Shader.empty() ? Counters.Shader : Pass.Shader);
		Writer.Member("entry", Pass.Entry.empty() ? Counters.Entry : Pass.Entry);
		Writer.Member("runsAs", Run != nullptr ? DescribeShaderRun(Counters.Ran) : Pass.RunsAs);
		Writer.Member("pixels", Counters.Pixels);
		Writer.Member("taps", Run != nullptr ? Run->Taps : std::optional<uint64_t>(0));
		Writer.Member("bytesRead", Counters.BytesRead);
		Writer.Member("bytesWritten", Counters.BytesWritten);
		if (Run != nullptr && !Run->SameAs.empty())
		{
			Writer.Member("sameAs", Run->SameAs);
			Writer.Member("because", Run->SameBecause);
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
	}
	Writer.EndArray();
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
	Writer.Key("warnings").BeginArray();
	for (const FDiagnostic& Diagnostic : Result.Diagnostics)
	{
		std::string Where = Diagnostic.File;
		if (Diagnostic.Line > 0)
		{
			Where += ":" + std::to_string(Diagnostic.Line) + ":" + std::to_string(Diagnostic.Column);
		}
		Where += (Where.empty() || Diagnostic.Where.empty() ? "" : " ") + Diagnostic.Where;
		Writer.BeginObject(true);
		Writer.Member("code", FormatCode(Diagnostic.Code));
		Writer.Member("message", Diagnostic.Message);
		Writer.Member("where", Where);
		Writer.EndObject();
	}
	Writer.EndArray();
}

void WriteSize(FJsonWriter& Writer, const char* Name, std::initializer_list<int32> Numbers)
{
	Writer.Key(Name).BeginArray(true);
	for (const int32 Number : Numbers)
	{
		Writer.Value(Number);
	}
	Writer.EndArray();
}

/** Writes the result of "auto"; nothing for a number. */
void WriteExposure(FJsonWriter& Writer, const std::optional<FExposureReport>& Exposure)
{
	if (!Exposure)
	{
		return;
	}
	Writer.Member("method", Exposure->Method);
	Writer.Member("targetScale", Exposure->TargetScale);
	Writer.Member("averageLuminance", Exposure->AverageLuminance);
	Writer.Member("ev100", Exposure->EV100);
	Writer.Member("compensation", Exposure->Compensation);
	Writer.Member("averageLocalExposure", Exposure->AverageLocalExposure);
	if (Exposure->Histogram)
	{
		Writer.Key("histogram").BeginObject();
		Writer.Member("logMin", Exposure->Histogram->LogMin);
		Writer.Member("logMax", Exposure->Histogram->LogMax);
		Writer.Member("lowPercent", Exposure->Histogram->LowPercent);
		Writer.Member("highPercent", Exposure->Histogram->HighPercent);
		Writer.Key("buckets").BeginArray(true);
		for (const double Bucket : Exposure->Histogram->Buckets)
		{
			Writer.Value(Bucket);
		}
		Writer.EndArray();
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
	Writer.Key("views").BeginArray();
	for (const FRunView& View : Result.Views)
	{
		Writer.BeginObject();
		Writer.Member("name", View.Name);
		WriteSize(Writer, "rect", {View.Rect.Min.X, View.Rect.Min.Y, View.Rect.Max.X, View.Rect.Max.Y});
		Writer.Member("exposureScale", View.ExposureScale);
		if (View.Exposure)
		{
			Writer.Key("exposure").BeginObject();
			WriteExposure(Writer, View.Exposure);
			Writer.EndObject();
		}
		WriteEffects(Writer, View.Effects, View.Figures);
		Writer.EndObject();
	}
	Writer.EndArray();
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
	const FIntRect& Rect = Result.ViewRect;
	FJsonWriter Writer;
	Writer.BeginObject();
	Writer.Member("version", GetVersion());
	Writer.Member("config", Result.Config.File);
	Writer.Member("engine", Result.Config.Engine.Value);
	Writer.Member("precision", Result.Precision);
	if (!Result.Device.empty())
	{
		Writer.Member("device", Result.Device);
	}
	Writer.Member("storage", Result.Storage);
	if (!Result.BudgetReason.empty())
	{
		Writer.Member("budget", Result.BudgetReason);
	}
	Writer.Key("scene").BeginObject();
	Writer.Member("file", Result.Config.Scene.File.Value);
	WriteSize(Writer, "extent", {Result.SceneExtent.X, Result.SceneExtent.Y});
	WriteSize(Writer, "viewRect", {Rect.Min.X, Rect.Min.Y, Rect.Max.X, Rect.Max.Y});
	Writer.Key("lightColor").BeginArray(true);
	for (const float Component : {Result.LightColor.R, Result.LightColor.G, Result.LightColor.B})
	{
		Writer.Value(Component);
	}
	Writer.EndArray();
	Writer.EndObject();
	Writer.Key("exposure").BeginObject(!Result.Exposure.has_value());
	Writer.Member("scale", Result.ExposureScale);
	Writer.Member("preExposure", Result.Config.View.PreExposure.Value);
	WriteExposure(Writer, Result.Exposure);
	Writer.EndObject();
	WriteSettings(Writer, Result);
	WriteEffects(Writer, Result.Effects, Result.Figures);
	WriteViews(Writer, Result);
	WriteHookCalls(Writer, Result);
	WritePasses(Writer, Result);
	Writer.Key("memory").BeginObject(true);
	Writer.Member("transientPeakBytes", Result.Graph.Memory.TransientPeakBytes);
	Writer.Member("withoutAliasingBytes", Result.Graph.Memory.WithoutAliasingBytes);
	Writer.EndObject();
	Writer.Key("channels").BeginArray();
	for (const FSceneChannel& Channel : Result.Channels)
	{
		Writer.BeginObject(true);
		Writer.Member("name", Channel.Name);
		Writer.Member("decoded", Channel.bDecoded);
		Writer.EndObject();
	}
	Writer.EndArray();
	WriteOutputs(Writer, Result);
	WriteWarnings(Writer, Result);
	Writer.EndObject();
	return Writer.GetText();
}

std::string MakeTimingJson(const FRunResult& Result, double SaveMs)
{
	FJsonWriter Writer;
	Writer.BeginObject();
	Writer.Member("threads", Result.Threads);
	Writer.Member("cpu", GetCpuName());
	Writer.Key("passes").BeginArray();
	for (const FRunPass& Pass : Result.Passes)
	{
		Writer.BeginObject(true);
		Writer.Member("index", Pass.Index);
		Writer.Member("name", Result.Graph.Passes[static_cast<size_t>(Pass.Index)].Name);
		Writer.Member("ms", Pass.Milliseconds);
		Writer.Member("taps", Pass.Taps);
		Writer.Member("runsAs", DescribeShaderRun(Pass.Counters.Ran));
		Writer.EndObject();
	}
	Writer.EndArray();
	Writer.Member("startMs", Result.Times.Start);
	Writer.Member("setupMs", Result.Times.Setup);
	Writer.Member("loadMs", Result.Times.Load);
	Writer.Member("compileMs", Result.Times.Compile);
	Writer.Member("executeMs", Result.Times.Execute);
	Writer.Member("reportMs", Result.Times.Report);
	Writer.Member("saveMs", SaveMs);
	const std::chrono::duration<double, std::milli> Wall = std::chrono::steady_clock::now() - Result.Times.Begin;
	Writer.Member("wallMs", Result.Times.Start + Wall.count());
	// Counts for the process: packs of lanes whose texels were read or written one by one.
	Writer.Key("scalarCalls").BeginObject(true);
	for (uint8_t Index = 0; Index < uint8_t(EScalarCall::Count); ++Index)
	{
		Writer.Member(GetScalarCallName(EScalarCall(Index)), GetScalarCalls(EScalarCall(Index)));
	}
	Writer.EndObject();
	Writer.EndObject();
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
		Writer.Member("name", Name);
		Writer.Member("cat", Category);
		Writer.Member("ph", "X");
		Writer.Member("ts", Now * 1000.0);
		Writer.Member("dur", Milliseconds * 1000.0);
		Writer.Member("pid", 1);
		Writer.Member("tid", 1);
		Writer.Key("args").BeginObject();
		if (Pass != nullptr)
		{
			Writer.Member("shader", Pass->Counters.Shader);
			Writer.Member("runsAs", DescribeShaderRun(Pass->Counters.Ran));
			Writer.Member("pixels", Pass->Counters.Pixels);
			Writer.Member("taps", Pass->Taps);
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
	Writer.EndArray();
	Writer.EndObject();
	return Writer.GetText();
}

} // namespace Drydock
