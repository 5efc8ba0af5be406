// Writes FShaderReflection as JSON and reads it back, for the cache.
#include <nlohmann/json.hpp>

#include "ShaderCache.h"

namespace Drydock
{

namespace
{

using FJson = nlohmann::json;

// One list of fields serves both directions: an archive either writes J[Name] = Field or reads it back;
// names and fields take turns.
struct FWriter
{
	FJson& J;
	template<typename T, typename... TRest>
	void operator()(const char* Name, T& Field, TRest&... Rest)
	{
		if constexpr (std::is_enum_v<T>)
		{
			J[Name] = int(Field);
		}
		else
		{
			J[Name] = Field;
		}
		if constexpr (sizeof...(Rest) > 0)
		{
			(*this)(Rest...);
		}
	}
};
struct FReader
{
	const FJson& J;
	template<typename T, typename... TRest>
	void operator()(const char* Name, T& Field, TRest&... Rest)
	{
		if constexpr (std::is_enum_v<T>)
		{
			Field = T(J.at(Name).get<int>());
		}
		else
		{
			Field = J.at(Name).get<T>();
		}
		if constexpr (sizeof...(Rest) > 0)
		{
			(*this)(Rest...);
		}
	}
};

template<typename TArchive>
void Fields(TArchive A, FShaderConstant& C)
{
	A("name", C.Name, "scalar", C.Scalar, "rows", C.Rows, "columns", C.Columns, "elements", C.NumElements, "buffer",
		C.Buffer, "offset", C.Offset, "arrayStride", C.ArrayStride, "matrixStride", C.MatrixStride, "rowMajor",
		C.bRowMajor, "used", C.bUsed, "where", C.Where);
}
template<typename TArchive>
void Fields(TArchive A, FShaderConstantBuffer& B)
{
	A("name", B.Name, "size", B.Size);
}
template<typename TArchive>
void Fields(TArchive A, FShaderResource& R)
{
	A("name", R.Name, "dimension", R.Dimension, "scalar", R.Scalar, "components", R.NumComponents, "stride", R.Stride,
		"counterOf", R.CounterOf, "counter", R.Counter, "compares", R.bCompares, "implicitLevel", R.bImplicitLevel,
		"where", R.Where);
}
template<typename TArchive>
void Fields(TArchive A, FShaderReflection& R)
{
	A("stage", R.Stage, "groupX", R.GroupSize[0], "groupY", R.GroupSize[1], "groupZ", R.GroupSize[2], "targets",
		R.NumTargets, "integerTargets", R.IntegerTargets, "depth", R.bWritesDepth, "interpolants", R.NumInterpolants,
		"integerInterpolants", R.IntegerInterpolants, "named", R.NamedInterpolants, "discard", R.bUsesDiscard,
		"loadsStored", R.bLoadsStored, "groups", R.bGroups, "groupsInOrder", R.bGroupsInOrder, "partedBarrier",
		R.PartedBarrier, "quads", R.bQuads, "samples", R.StaticSamples);
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
