// Writes a compiled graph as JSON.
#include "Run/GraphJson.h"

#include "RenderGraphDump.h"
#include "Text/JsonWriter.h"

namespace Drydock
{

namespace
{

void WriteUse(FJsonWriter& Writer, const FRDGUse& Use)
{
	Writer.BeginObject(true);
	Writer.Member("resource", Use.Resource);
	Writer.Member("parameter", Use.Parameter);
	Writer.Member("reads", Use.IsRead());
	Writer.Member("writes", Use.IsWrite());
	Writer.Member("firstMip", Use.FirstMip);
	Writer.Member("numMips", Use.NumMips);
	Writer.EndObject();
}

void WritePass(FJsonWriter& Writer, const FRDGCompiledGraph& Graph, const FRDGCompiledPass& Pass,
	const std::vector<FPassValue>& Values)
{
	Writer.BeginObject();
	Writer.Member("index", Pass.Index);
	Writer.Member("name", Pass.Name);
	Writer.Member("scope", Pass.Scope);
	Writer.Member("flags", DescribePassFlags(Pass.Flags));
	Writer.Member("culled", Pass.bCulled);
	Writer.Member("reason", Graph.DescribeCulled(Pass));
	Writer.Member("shader", Pass.Shader);
	Writer.Member("entry", Pass.Entry);
	Writer.Member("runsAs", Pass.RunsAs);
	Writer.Member("effect", Pass.Effect);
	Writer.Member("owner", Pass.Owner);
	Writer.Member("renderPassBegin", Pass.RenderPassBegin);
	Writer.Member("renderPassEnd", Pass.RenderPassEnd);
	Writer.Member("mergeReason", Pass.MergeReason);
	WriteValues(Writer, Values);
	Writer.Key("producers").BeginArray(true);
	for (const int32_t Producer : Pass.Producers)
	{
		Writer.Value(Producer);
	}
	Writer.EndArray();
	Writer.Key("uses").BeginArray();
	for (const FRDGUse& Use : Pass.Uses)
	{
		WriteUse(Writer, Use);
	}
	Writer.EndArray();
	Writer.EndObject();
}

void WriteResource(FJsonWriter& Writer, const FRDGCompiledGraph& Graph, int32_t Index)
{
	const FRDGCompiledResource& Resource = Graph.Resources[static_cast<size_t>(Index)];
	Writer.BeginObject(true);
	Writer.Member("index", Index);
	Writer.Member("name", Resource.Name);
	Writer.Member("kind", Resource.Kind == ERDGResourceKind::Texture ? "texture" : "buffer");
	Writer.Member("shape", DescribeResource(Resource));
	Writer.Member("bytes", Resource.Bytes);
	Writer.Member("external", Resource.bExternal);
	Writer.Member("extracted", Resource.bExtracted);
	Writer.Member("transient", Resource.bTransient);
	Writer.Member("firstPass", Resource.FirstPass);
	Writer.Member("lastPass", Resource.LastPass);
	Writer.Member("heapOffset", Resource.HeapOffset);
	Writer.Member("reason", Graph.DescribeUnused(Resource));
	Writer.EndObject();
}

void WriteTransition(FJsonWriter& Writer, const FRDGTransition& Transition)
{
	Writer.BeginObject(true);
	Writer.Member("resource", Transition.Resource);
	Writer.Member("before", static_cast<uint32_t>(Transition.Before));
	Writer.Member("after", static_cast<uint32_t>(Transition.After));
	Writer.Member("beginPass", Transition.BeginPass);
	Writer.Member("endPass", Transition.EndPass);
	Writer.EndObject();
}

} // namespace

std::string MakeGraphJson(const FRDGCompiledGraph& Graph, const std::map<int, std::vector<FPassValue>>& Values)
{
	FJsonWriter Writer;
	Writer.BeginObject();
	Writer.Member("name", Graph.Name);
	Writer.Key("passes").BeginArray();
	for (const FRDGCompiledPass& Pass : Graph.Passes)
	{
		if (!Pass.bIsSentinel)
		{
			const auto Found = Values.find(Pass.Index);
			WritePass(Writer, Graph, Pass, Found == Values.end() ? std::vector<FPassValue>() : Found->second);
		}
	}
	Writer.EndArray();
	Writer.Key("resources").BeginArray();
	for (size_t Index = 0; Index < Graph.Resources.size(); ++Index)
	{
		WriteResource(Writer, Graph, static_cast<int32_t>(Index));
	}
	Writer.EndArray();
	Writer.Key("transitions").BeginArray();
	for (const FRDGTransition& Transition : Graph.Transitions)
	{
		WriteTransition(Writer, Transition);
	}
	Writer.EndArray();
	Writer.Key("memory").BeginObject(true);
	Writer.Member("transientPeakBytes", Graph.Memory.TransientPeakBytes);
	Writer.Member("withoutAliasingBytes", Graph.Memory.WithoutAliasingBytes);
	Writer.Member("pooledBytes", Graph.Memory.PooledBytes);
	Writer.Member("externalBytes", Graph.Memory.ExternalBytes);
	Writer.EndObject();
	Writer.EndObject();
	return Writer.GetText();
}

} // namespace Drydock
