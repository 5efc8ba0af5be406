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
	Writer.Object({{"resource", Use.Resource}, {"parameter", Use.Parameter}, {"reads", Use.IsRead()},
		{"writes", Use.IsWrite()}, {"firstMip", Use.FirstMip}, {"numMips", Use.NumMips}});
}

void WritePass(FJsonWriter& Writer, const FRDGCompiledGraph& Graph, const FRDGCompiledPass& Pass,
	const std::vector<FPassValue>& Values)
{
	Writer.BeginObject();
	Writer.Members({{"index", Pass.Index}, {"name", Pass.Name}, {"scope", Pass.Scope},
		{"flags", DescribePassFlags(Pass.Flags)}, {"culled", Pass.bCulled}, {"reason", Graph.DescribeCulled(Pass)},
		{"shader", Pass.Shader}, {"entry", Pass.Entry}, {"runsAs", Pass.RunsAs}, {"effect", Pass.Effect},
		{"owner", Pass.Owner}, {"renderPassBegin", Pass.RenderPassBegin}, {"renderPassEnd", Pass.RenderPassEnd},
		{"mergeReason", Pass.MergeReason}});
	WriteValues(Writer, Values);
	Writer.Member("producers", Pass.Producers);
	Writer.Array("uses", Pass.Uses, [&](const FRDGUse& Use) { WriteUse(Writer, Use); });
	Writer.EndObject();
}

void WriteResource(FJsonWriter& Writer, const FRDGCompiledGraph& Graph, int32_t Index)
{
	const FRDGCompiledResource& Resource = Graph.Resources[static_cast<size_t>(Index)];
	Writer.Object({{"index", Index}, {"name", Resource.Name},
		{"kind", Resource.Kind == ERDGResourceKind::Texture ? "texture" : "buffer"},
		{"shape", DescribeResource(Resource)}, {"bytes", Resource.Bytes}, {"external", Resource.bExternal},
		{"extracted", Resource.bExtracted}, {"transient", Resource.bTransient}, {"firstPass", Resource.FirstPass},
		{"lastPass", Resource.LastPass}, {"heapOffset", Resource.HeapOffset},
		{"reason", Graph.DescribeUnused(Resource)}});
}

void WriteTransition(FJsonWriter& Writer, const FRDGTransition& Transition)
{
	Writer.Object({{"resource", Transition.Resource}, {"before", static_cast<uint32_t>(Transition.Before)},
		{"after", static_cast<uint32_t>(Transition.After)}, {"beginPass", Transition.BeginPass},
		{"endPass", Transition.EndPass}});
}

} // namespace

std::string MakeGraphJson(const FRDGCompiledGraph& Graph, const std::map<int, std::vector<FPassValue>>& Values)
{
	FJsonWriter Writer('{');
	Writer.Member("name", Graph.Name);
	Writer.Array("passes", Graph.Passes,
		[&](const FRDGCompiledPass& Pass)
		{
			if (!Pass.bIsSentinel)
			{
				const auto Found = Values.find(Pass.Index);
				WritePass(Writer, Graph, Pass, Found == Values.end() ? std::vector<FPassValue>() : Found->second);
			}
		});
	Writer.Array("resources", std::views::iota(int32_t(0), static_cast<int32_t>(Graph.Resources.size())),
		[&](int32_t Index) { WriteResource(Writer, Graph, Index); });
	Writer.Array("transitions", Graph.Transitions,
		[&](const FRDGTransition& Transition) { WriteTransition(Writer, Transition); });
	Writer.Key("memory").Object({{"transientPeakBytes", Graph.Memory.TransientPeakBytes},
		{"withoutAliasingBytes", Graph.Memory.WithoutAliasingBytes}, {"pooledBytes", Graph.Memory.PooledBytes},
		{"externalBytes", Graph.Memory.ExternalBytes}});
	return Writer.GetText();
}

} // namespace Drydock
