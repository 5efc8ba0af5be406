// Writes FShaderReflection as JSON and reads it back, for the cache.
#include <nlohmann/json.hpp>

#include "ShaderCache.h"

namespace Drydock
{

namespace
{

using FJson = nlohmann::json;

// One list of fields serves both directions: an archive either writes J[Name] = Field or reads it back.
struct FWriter
{
	FJson& J;
	template<typename T>
	void operator()(const char* Name, T& Field)
	{
		if constexpr (std::is_enum_v<T>)
		{
			J[Name] = int(Field);
		}
		else
		{
			J[Name] = Field;
		}
	}
};
struct FReader
{
	const FJson& J;
	template<typename T>
	void operator()(const char* Name, T& Field)
	{
		if constexpr (std::is_enum_v<T>)
		{
			Field = T(J.at(Name).get<int>());
		}
		else
		{
			Field = J.at(Name).get<T>();
		}
	}
};

template<typename TArchive>
void Fields(TArchive A, FShaderConstant& C)
{
	A("name", C.Name);
	A("scalar", C.Scalar);
	A("rows", C.Rows);
	A("columns", C.Columns);
	A("elements", C.NumElements);
	A("buffer", C.Buffer);
	A("offset", C.Offset);
	A("arrayStride", C.ArrayStride);
	A("matrixStride", C.MatrixStride);
	A("rowMajor", C.bRowMajor);
	A("used", C.bUsed);
	A("where", C.Where);
}
template<typename TArchive>
void Fields(TArchive A, FShaderConstantBuffer& B)
{
	A("name", B.Name);
	A("size", B.Size);
}
template<typename TArchive>
void Fields(TArchive A, FShaderResource& R)
{
	A("name", R.Name);
	A("dimension", R.Dimension);
	A("scalar", R.Scalar);
	A("components", R.NumComponents);
	A("stride", R.Stride);
	A("counterOf", R.CounterOf);
	A("counter", R.Counter);
	A("compares", R.bCompares);
	A("implicitLevel", R.bImplicitLevel);
	A("where", R.Where);
}
template<typename TArchive>
void Fields(TArchive A, FShaderReflection& R)
{
	A("stage", R.Stage);
	A("groupX", R.GroupSize[0]);
	A("groupY", R.GroupSize[1]);
	A("groupZ", R.GroupSize[2]);
	A("targets", R.NumTargets);
	A("interpolants", R.NumInterpolants);
	A("discard", R.bUsesDiscard);
	A("groups", R.bGroups);
	A("groupsInOrder", R.bGroupsInOrder);
	A("partedBarrier", R.PartedBarrier);
	A("quads", R.bQuads);
	A("samples", R.StaticSamples);
}

template<typename T>
FJson WriteList(std::vector<T>& List)
{
	FJson Result = FJson::array();
	for (T& Item : List)
	{
		FJson J;
		Fields(FWriter{J}, Item);
		Result.push_back(std::move(J));
	}
	return Result;
}
template<typename T>
void ReadList(const FJson& J, std::vector<T>& List)
{
	for (const FJson& Item : J)
	{
		Fields(FReader{Item}, List.emplace_back());
	}
}

template<typename F>
void ForEachList(FShaderReflection& R, F f)
{
	f("constantBuffers", R.ConstantBuffers);
	f("constants", R.Constants);
	f("textures", R.Textures);
	f("rwTextures", R.RWTextures);
	f("samplers", R.Samplers);
	f("buffers", R.Buffers);
	f("rwBuffers", R.RWBuffers);
}

} // namespace

std::string ReflectionToJson(const FShaderReflection& Reflection)
{
	FShaderReflection Copy = Reflection;
	FJson J;
	Fields(FWriter{J}, Copy);
	ForEachList(Copy, [&J](const char* Name, auto& List) { J[Name] = WriteList(List); });
	return J.dump(1, '\t', false, FJson::error_handler_t::replace);
}

std::optional<FShaderReflection> ReflectionFromJson(const std::string& Text)
{
	try
	{
		const FJson J = FJson::parse(Text);
		FShaderReflection Result;
		Fields(FReader{J}, Result);
		ForEachList(Result, [&J](const char* Name, auto& List) { ReadList(J.at(Name), List); });
		return Result;
	}
	catch (const FJson::exception&)
	{
		return {};
	}
}

} // namespace Drydock
