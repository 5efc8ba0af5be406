// Source: drydock; meaning of the instructions: SPIR-V specification, section 3.
#include "SpirvInterpreter.h"

#include "Lanes.h"
#include "SpirvPlace.h"
#include "SpirvScalarMath.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace Drydock
{

using namespace Spirv;

class FSpirvInterpreterImpl
{
public:
	FSpirvInterpreterImpl(const FSpirvModule& InModule, const FSpirvReflection& InReflection)
		: Module(InModule)
		, Reflection(InReflection)
	{
		for (const FSpirvBlock& Block : Module.Blocks)
		{
			for (const FSpirvInstruction& I : Block.Instructions)
			{
				if (I.Result)
				{
					Definitions[I.Result] = &I;
				}
			}
		}
	}

	FInterpretedPixel Run(const FKernelArgs& InArgs, int32_t X, int32_t Y, int32_t Z, uint64_t MaxSteps);

private:
	using FScalars = std::vector<uint32_t>;

	void Execute(const FSpirvInstruction& I);
	bool ExecuteComposite(const FSpirvInstruction& I, FScalars& Result);
	bool ExecuteMatrix(const FSpirvInstruction& I, FScalars& Result);
	bool ExecuteImage(const FSpirvInstruction& I, FScalars& Result);
	void ExecuteExtended(const FSpirvInstruction& I, FScalars& Result);
	FScalars Load(uint32_t Pointer);
	void Store(uint32_t Pointer, const FScalars& Value);
	FScalars LoadInput(const FSpirvVariable& Variable) const;
	uint32_t ChooseTarget(const FSpirvInstruction& Terminator);
	void EnterBlock(const FSpirvBlock& Block, uint32_t From);

	const FScalars& Get(uint32_t Id)
	{
		if (const FSpirvConstant* Constant = Module.FindConstant(Id))
		{
			return Constant->Scalars;
		}
		FScalars& Value = Values[Id];
		Value.resize(Module.GetValueType(Id).NumScalars, 0);
		return Value;
	}
	float GetFloat(uint32_t Id, uint32_t Index) { return ToFloat(Get(Id)[Index]); }
	FSpirvPlace Resolve(uint32_t Pointer) const
	{
		const auto Chain = Definitions.find(Pointer);
		return ResolvePlace(Module, Pointer, Chain == Definitions.end() ? nullptr : Chain->second);
	}
	uint32_t DynamicOffset(const FSpirvPlace& Place)
	{
		uint32_t Offset = Place.Offset;
		for (const FSpirvIndex& Index : Place.Indices)
		{
			Offset += std::min(Get(Index.Value)[0], Index.Count - 1) * Index.Stride;
		}
		return Offset;
	}
	const FSpirvVariable& HandleOf(uint32_t Id) const;
	uint32_t SlotOf(uint32_t Id) const { return Reflection.Slots.at(HandleOf(Id).Id); }

	const FSpirvModule& Module;
	const FSpirvReflection& Reflection;
	std::map<uint32_t, const FSpirvInstruction*> Definitions;
	std::unordered_map<uint32_t, FScalars> Values;
	std::unordered_map<uint32_t, FScalars> Memory; // variables of the thread
	const FKernelArgs* Args = nullptr;
	int32_t Position[3] = {};
	bool bDiscarded = false;
};

const FSpirvVariable& FSpirvInterpreterImpl::HandleOf(uint32_t Id) const
{
	for (int Steps = 0; Steps < 8; ++Steps)
	{
		if (const FSpirvVariable* Variable = Module.FindVariable(Id))
		{
			return *Variable;
		}
		const auto Found = Definitions.find(Id);
		if (Found == Definitions.end() || Found->second->Operands.empty())
		{
			break;
		}
		Id = Found->second->Operands[0];
	}
	Module.Fail("SPIR-V: a texture or sampler that is not a variable");
}

FSpirvInterpreterImpl::FScalars FSpirvInterpreterImpl::LoadInput(const FSpirvVariable& Variable) const
{
	const int32_t* const Group = Reflection.Reflection.GroupSize;
	const auto Local = [this, Group](int Axis) { return uint32_t(Position[Axis] % Group[Axis]); };
	switch (Variable.BuiltIn)
	{
	case BuiltInGlobalInvocationId:
		return {uint32_t(Position[0]), uint32_t(Position[1]), uint32_t(Position[2])};
	case BuiltInWorkgroupId:
		return {uint32_t(Position[0] / Group[0]), uint32_t(Position[1] / Group[1]), uint32_t(Position[2] / Group[2])};
	case BuiltInLocalInvocationId:
		return {Local(0), Local(1), Local(2)};
	case BuiltInLocalInvocationIndex:
		return {(Local(2) * uint32_t(Group[1]) + Local(1)) * uint32_t(Group[0]) + Local(0)};
	case BuiltInFragCoord:
		return {ToBits(float(Position[0]) + 0.5f), ToBits(float(Position[1]) + 0.5f), ToBits(0.0f), ToBits(1.0f)};
	case BuiltInFrontFacing:
		return {1};
	default:
	{
		FScalars Result;
		const FKernelInterpolant& Interpolant = Args->Interpolants[GetTexCoordIndex(Variable.Semantic)];
		for (uint32_t i = 0; i < Module.GetType(Variable.Type).NumScalars; ++i)
		{
			Result.push_back(ToBits(Lanes::Interpolate<float>(Interpolant, int(i), Lanes::TInt<4>(Position[0]), Position[1])[0]));
		}
		return Result;
	}
	}
}

FSpirvInterpreterImpl::FScalars FSpirvInterpreterImpl::Load(uint32_t Pointer)
{
	const FSpirvPlace Place = Resolve(Pointer);
	const uint32_t Offset = DynamicOffset(Place);
	FScalars Result;
	for (const uint32_t Part : Place.Scalars)
	{
		const uint32_t At = Offset + Part;
		if (!Place.bBytes)
		{
			const FScalars& Whole = Place.Variable->Storage == StorageInput ? (Memory[Place.Variable->Id] = LoadInput(*Place.Variable)) : Memory[Place.Variable->Id];
			Result.push_back(At < Whole.size() ? Whole[At] : 0);
			continue;
		}
		uint32_t Bits = 0;
		const uint32_t Slot = Reflection.Slots.at(Place.Variable->Id);
		const FSpirvType& Type = Module.GetType(Place.Variable->Type);
		if (!Type.bBufferBlock)
		{
			std::memcpy(&Bits, Args->ConstantBuffers[Slot] + At, 4);
		}
		else
		{
			const FKernelBuffer& Buffer = Type.Members[0].bNonWritable ? Args->Buffers[Slot] : Args->RWBuffers[Slot];
			const uint64_t Byte = uint64_t(Get(Place.Element)[0]) * Place.ElementStride + At;
			if (Get(Place.Element)[0] < Buffer.SizeInBytes / Place.ElementStride && Byte + 4 <= Buffer.SizeInBytes)
			{
				std::memcpy(&Bits, Buffer.Data + Byte, 4);
			}
		}
		Result.push_back(Bits);
	}
	return Result;
}

void FSpirvInterpreterImpl::Store(uint32_t Pointer, const FScalars& Value)
{
	const FSpirvPlace Place = Resolve(Pointer);
	const uint32_t Offset = DynamicOffset(Place);
	for (size_t i = 0; i < Place.Scalars.size() && i < Value.size(); ++i)
	{
		const uint32_t At = Offset + Place.Scalars[i];
		if (!Place.bBytes)
		{
			FScalars& Whole = Memory[Place.Variable->Id];
			if (At < Whole.size())
			{
				Whole[At] = Value[i];
			}
			continue;
		}
		if (!Place.ElementStride)
		{
			Module.Fail("a store into '" + Place.Variable->Name + "', which is read-only");
		}
		const FKernelBuffer& Buffer = Args->RWBuffers[Reflection.Slots.at(Place.Variable->Id)];
		const uint64_t Byte = uint64_t(Get(Place.Element)[0]) * Place.ElementStride + At;
		if (Get(Place.Element)[0] < Buffer.SizeInBytes / Place.ElementStride && Byte + 4 <= Buffer.SizeInBytes)
		{
			std::memcpy(Buffer.Data + Byte, &Value[i], 4);
		}
	}
}

bool FSpirvInterpreterImpl::ExecuteComposite(const FSpirvInstruction& I, FScalars& Result)
{
	switch (I.Op)
	{
	case OpVectorShuffle:
	{
		FScalars Both = Get(I.Operands[0]);
		const FScalars& Second = Get(I.Operands[1]);
		Both.insert(Both.end(), Second.begin(), Second.end());
		for (size_t i = 2; i < I.Operands.size(); ++i)
		{
			Result.push_back(I.Operands[i] == ~0u ? 0 : Both[I.Operands[i]]);
		}
		return true;
	}
	case OpCompositeConstruct:
		for (const uint32_t Part : I.Operands)
		{
			const FScalars& Value = Get(Part);
			Result.insert(Result.end(), Value.begin(), Value.end());
		}
		return true;
	case OpCompositeExtract:
	case OpCompositeInsert:
	{
		const size_t Composite = I.Op == OpCompositeInsert ? 1 : 0;
		uint32_t Type = Module.GetValueTypeId(I.Operands[Composite]);
		uint32_t Offset = 0;
		for (size_t i = Composite + 1; i < I.Operands.size(); ++i)
		{
			Offset += Module.GetMemberScalar(Type, I.Operands[i]);
			Type = Module.GetMemberType(Type, I.Operands[i]);
		}
		const FScalars Whole = Get(I.Operands[Composite]);
		if (I.Op == OpCompositeExtract)
		{
			Result.assign(Whole.begin() + Offset, Whole.begin() + Offset + Module.GetType(Type).NumScalars);
			return true;
		}
		const FScalars& Part = Get(I.Operands[0]);
		Result = Whole;
		std::copy(Part.begin(), Part.end(), Result.begin() + Offset);
		return true;
	}
	case OpVectorExtractDynamic:
	{
		const FScalars& Vector = Get(I.Operands[0]);
		Result = {Vector[std::min<size_t>(Get(I.Operands[1])[0], Vector.size() - 1)]};
		return true;
	}
	case OpVectorInsertDynamic:
	{
		Result = Get(I.Operands[0]);
		const uint32_t Index = Get(I.Operands[2])[0];
		if (Index < Result.size())
		{
			Result[Index] = Get(I.Operands[1])[0];
		}
		return true;
	}
	default:
		return false;
	}
}

bool FSpirvInterpreterImpl::ExecuteMatrix(const FSpirvInstruction& I, FScalars& Result)
{
	// Element (Row, Column) of an operand that has Rows rows.
	const auto At = [this, &I](size_t Operand, uint32_t Rows, uint32_t Row, uint32_t Column) { return GetFloat(I.Operands[Operand], Column * Rows + Row); };
	const uint32_t Size = Module.GetType(I.Type).NumScalars;
	const auto Count = [this, &I](size_t Operand) { return Module.GetValueType(I.Operands[Operand]).NumScalars; };
	switch (I.Op)
	{
	case OpVectorTimesScalar:
	case OpMatrixTimesScalar:
		for (uint32_t i = 0; i < Size; ++i)
		{
			Result.push_back(ToBits(GetFloat(I.Operands[0], i) * GetFloat(I.Operands[1], 0)));
		}
		return true;
	case OpDot:
	case OpVectorTimesMatrix:
	{
		const uint32_t Rows = Count(0);
		for (uint32_t Column = 0; Column < Size; ++Column)
		{
			float Sum = At(0, Rows, 0, 0) * At(1, Rows, 0, Column);
			for (uint32_t Row = 1; Row < Rows; ++Row)
			{
				Sum += At(0, Rows, Row, 0) * At(1, Rows, Row, Column);
			}
			Result.push_back(ToBits(Sum));
		}
		return true;
	}
	case OpMatrixTimesVector:
	case OpMatrixTimesMatrix:
	{
		const uint32_t Inner = Module.GetValueType(I.Operands[0]).Count;
		const uint32_t Rows = Count(0) / Inner;
		for (uint32_t i = 0; i < Size; ++i)
		{
			float Sum = At(0, Rows, i % Rows, 0) * At(1, Inner, 0, i / Rows);
			for (uint32_t k = 1; k < Inner; ++k)
			{
				Sum += At(0, Rows, i % Rows, k) * At(1, Inner, k, i / Rows);
			}
			Result.push_back(ToBits(Sum));
		}
		return true;
	}
	case OpOuterProduct:
		for (uint32_t i = 0; i < Size; ++i)
		{
			Result.push_back(ToBits(GetFloat(I.Operands[0], i % Count(0)) * GetFloat(I.Operands[1], i / Count(0))));
		}
		return true;
	case OpTranspose:
	{
		const uint32_t Columns = Module.GetType(I.Type).Count;
		const uint32_t Rows = Size / Columns;
		for (uint32_t i = 0; i < Size; ++i)
		{
			Result.push_back(Get(I.Operands[0])[(i % Rows) * Columns + i / Rows]);
		}
		return true;
	}
	case OpAny:
	case OpAll:
	{
		const FScalars& Value = Get(I.Operands[0]);
		const auto IsSet = [](uint32_t Bits) { return Bits != 0; };
		Result = {uint32_t(I.Op == OpAny ? std::any_of(Value.begin(), Value.end(), IsSet) : std::all_of(Value.begin(), Value.end(), IsSet))};
		return true;
	}
	default:
		return false;
	}
}

bool FSpirvInterpreterImpl::ExecuteImage(const FSpirvInstruction& I, FScalars& Result)
{
	// Textures are read by the library's sampler with the same thread in all of its lanes.
	constexpr int N = 4;
	using FSampling = Lanes::TSampling<float, N>;
	const auto Spread = [this](uint32_t Id, uint32_t Index, auto* Out)
	{
		const uint32_t Bits = Index < Get(Id).size() ? Get(Id)[Index] : 0;
		for (int Lane = 0; Lane < N; ++Lane)
		{
			std::memcpy(&Out[Lane], &Bits, 4);
		}
	};
	const auto Image = [this](uint32_t Id) -> const FSpirvType&
	{
		const FSpirvType& Type = Module.GetValueType(Id);
		return Type.Kind == ESpirvType::SampledImage ? Module.GetType(Type.Element) : Type;
	};
	const int32_t FirstLane[N] = {-1, 0, 0, 0};
	alignas(64) float Out[4 * N] = {};
	alignas(64) uint32_t UintOut[4 * N] = {};
	const auto Texture = [this, &I]() -> const FKernelTexture&
	{
		const FSpirvVariable& Variable = HandleOf(I.Operands[0]);
		return (Module.GetType(Variable.Type).bStorageImage ? Args->RWTextures : Args->Textures)[SlotOf(I.Operands[0])];
	};
	const auto Buffer = [this, &I]() -> const FKernelBuffer&
	{
		const FSpirvVariable& Variable = HandleOf(I.Operands[0]);
		return (Module.GetType(Variable.Type).bStorageImage ? Args->RWBuffers : Args->Buffers)[SlotOf(I.Operands[0])];
	};
	switch (I.Op)
	{
	case OpSampledImage:
	case OpImage:
		return true;
	case OpImageSampleImplicitLod:
	case OpImageSampleExplicitLod:
	case OpImageGather:
	{
		const FSpirvType& Type = Image(I.Operands[0]);
		const size_t MaskAt = I.Op == OpImageGather ? 3 : 2;
		const uint32_t Mask = I.Operands.size() > MaskAt ? I.Operands[MaskAt] : 0;
		if (Mask & ~uint32_t(ImageLod))
		{
			Module.Fail("the model does not know samples with an offset", &I);
		}
		const FSpirvInstruction& Pair = *Definitions.at(I.Operands[0]);
		const FKernelTexture& Sampled = Args->Textures[SlotOf(Pair.Operands[0])];
		const FKernelSampler& Sampler = Args->Samplers[SlotOf(Pair.Operands[1])];
		alignas(64) float U[N], V[N], W[N], Level[N] = {};
		Spread(I.Operands[1], 0, U);
		Spread(I.Operands[1], 1, V);
		Spread(I.Operands[1], 2, W);
		if (Mask & ImageLod)
		{
			Spread(I.Operands[3], 0, Level);
		}
		if (I.Op == OpImageGather)
		{
			FSampling::Gather2D(Sampled, Sampler, U, V, int32_t(Module.GetConstantScalar(I.Operands[2])), Out);
		}
		else if (Type.Dim == Dim3D)
		{
			FSampling::Sample3D(Sampled, Sampler, U, V, W, Level, true, Out);
		}
		else
		{
			FSampling::Sample2D(Sampled, Sampler, U, V, Type.bArrayed ? W : nullptr, Level, true, Out);
		}
		break;
	}
	case OpImageFetch:
	case OpImageRead:
	{
		const FSpirvType& Type = Image(I.Operands[0]);
		const bool bInteger = Module.GetType(Type.Element).Kind != ESpirvType::Float;
		const uint32_t Mask = I.Operands.size() > 2 ? I.Operands[2] : 0;
		if (Mask & ~uint32_t(ImageLod))
		{
			Module.Fail("the model does not know loads with an offset", &I);
		}
		alignas(64) int32_t X[N], Y[N], Z[N], Mip[N] = {};
		Spread(I.Operands[1], 0, X);
		Spread(I.Operands[1], 1, Y);
		Spread(I.Operands[1], 2, Z);
		if (Mask & ImageLod)
		{
			Spread(I.Operands[3], 0, Mip);
		}
		const int32_t* const Depth = Type.Dim == Dim3D || Type.bArrayed ? Z : nullptr;
		if (Type.Dim == DimBuffer)
		{
			const auto* const Index = reinterpret_cast<const uint32_t*>(X);
			bInteger ? FSampling::LoadTypedUint(Buffer(), Index, UintOut) : FSampling::LoadTyped(Buffer(), Index, Out);
		}
		else
		{
			bInteger ? FSampling::LoadUint(Texture(), X, Y, Depth, Mip, true, UintOut) : FSampling::Load(Texture(), X, Y, Depth, Mip, true, Out);
		}
		if (bInteger)
		{
			std::memcpy(Out, UintOut, sizeof(Out));
		}
		break;
	}
	case OpImageWrite:
	{
		const FSpirvType& Type = Image(I.Operands[0]);
		const bool bInteger = Module.GetType(Type.Element).Kind != ESpirvType::Float;
		alignas(64) int32_t X[N], Y[N], Z[N];
		Spread(I.Operands[1], 0, X);
		Spread(I.Operands[1], 1, Y);
		Spread(I.Operands[1], 2, Z);
		for (uint32_t c = 0; c < 4; ++c)
		{
			Spread(I.Operands[2], c, Out + c * N);
			Spread(I.Operands[2], c, UintOut + c * N);
		}
		const int32_t* const Depth = Type.Dim == Dim3D || Type.bArrayed ? Z : nullptr;
		if (Type.Dim == DimBuffer)
		{
			const auto* const Index = reinterpret_cast<const uint32_t*>(X);
			bInteger ? FSampling::StoreTypedUint(Buffer(), FirstLane, Index, UintOut) : FSampling::StoreTyped(Buffer(), FirstLane, Index, Out);
		}
		else
		{
			bInteger ? FSampling::StoreUint(Texture(), FirstLane, X, Y, Depth, UintOut) : FSampling::Store(Texture(), FirstLane, X, Y, Depth, Out);
		}
		return true;
	}
	case OpImageQuerySize:
	case OpImageQuerySizeLod:
	{
		if (Image(I.Operands[0]).Dim == DimBuffer)
		{
			Result = {Lanes::BufferElements(Buffer())};
			return true;
		}
		const auto Size = Lanes::TextureSize3D(Texture(), I.Op == OpImageQuerySizeLod ? int32_t(Get(I.Operands[1])[0]) : 0);
		for (uint32_t i = 0; i < Module.GetType(I.Type).NumScalars; ++i)
		{
			Result.push_back(uint32_t(Size[int(i)]));
		}
		return true;
	}
	case OpImageQueryLevels:
		Result = {uint32_t(Texture().NumMips)};
		return true;
	default:
		return false;
	}
	for (int c = 0; c < 4; ++c)
	{
		Result.push_back(ToBits(Out[c * N]));
	}
	return true;
}

void FSpirvInterpreterImpl::ExecuteExtended(const FSpirvInstruction& I, FScalars& Result)
{
	const uint32_t Ext = I.Operands[1];
	const auto Vector = [this, &I](size_t Operand)
	{
		std::vector<float> Value;
		for (const uint32_t Bits : Get(I.Operands[Operand]))
		{
			Value.push_back(ToFloat(Bits));
		}
		return Value;
	};
	const auto Dot = [](const std::vector<float>& A, const std::vector<float>& B)
	{
		float Sum = A[0] * B[0];
		for (size_t i = 1; i < A.size(); ++i)
		{
			Sum += A[i] * B[i];
		}
		return Sum;
	};
	const auto Push = [&Result](float Value) { Result.push_back(ToBits(Value)); };
	const std::vector<float> A = Vector(2);
	switch (Ext)
	{
	case ExtLength:
		Push(A.size() == 1 ? std::fabs(A[0]) : std::sqrt(Dot(A, A)));
		return;
	case ExtDistance:
	{
		std::vector<float> Difference = Vector(3);
		for (size_t i = 0; i < A.size(); ++i)
		{
			Difference[i] = A[i] - Difference[i];
		}
		Push(A.size() == 1 ? std::fabs(Difference[0]) : std::sqrt(Dot(Difference, Difference)));
		return;
	}
	case ExtNormalize:
		for (const float Part : A)
		{
			Push(A.size() == 1 ? Lanes::Sign(Part) : Part * (1.0f / std::sqrt(Dot(A, A))));
		}
		return;
	case ExtCross:
	{
		const std::vector<float> B = Vector(3);
		Push(A[1] * B[2] - A[2] * B[1]);
		Push(A[2] * B[0] - A[0] * B[2]);
		Push(A[0] * B[1] - A[1] * B[0]);
		return;
	}
	case ExtReflect:
	{
		const std::vector<float> Normal = Vector(3);
		const float Twice = Dot(Normal, A) + Dot(Normal, A);
		for (size_t i = 0; i < A.size(); ++i)
		{
			Push(A[i] - Normal[i] * Twice);
		}
		return;
	}
	case ExtModf:
	{
		FScalars Whole;
		for (const float Part : A)
		{
			Push(Part - std::trunc(Part));
			Whole.push_back(ToBits(std::trunc(Part)));
		}
		Store(I.Operands[3], Whole);
		return;
	}
	case ExtLdexp:
		for (uint32_t i = 0; i < A.size(); ++i)
		{
			const bool bFloat = Module.GetScalarKind(Module.GetValueTypeId(I.Operands[3]), i) == ESpirvType::Float;
			Push(bFloat ? A[i] * Lanes::Exp2(GetFloat(I.Operands[3], i)) : Lanes::Ldexp(A[i], int32_t(Get(I.Operands[3])[i])));
		}
		return;
	case ExtPackHalf2x16:
		Result.push_back(Lanes::PackHalf2(Lanes::TVec<float, 2>(A[0], A[1])));
		return;
	case ExtUnpackHalf2x16:
	{
		const Lanes::TVec<float, 2> Both = Lanes::UnpackHalf2<float>(Get(I.Operands[2])[0]);
		Push(Both[0]);
		Push(Both[1]);
		return;
	}
	default:
		break;
	}
	for (uint32_t i = 0; i < Module.GetType(I.Type).NumScalars; ++i)
	{
		uint32_t Operands[3] = {};
		for (size_t k = 2; k < I.Operands.size() && k < 5; ++k)
		{
			Operands[k - 2] = Get(I.Operands[k])[i];
		}
		uint32_t Bits = 0;
		if (!EvaluateExtended(Ext, Operands, Bits))
		{
			Module.Fail("the model does not know GLSL.std.450 instruction " + std::to_string(Ext), &I);
		}
		Result.push_back(Bits);
	}
}

void FSpirvInterpreterImpl::Execute(const FSpirvInstruction& I)
{
	FScalars Result;
	switch (I.Op)
	{
	case OpLoad:
		if (Module.GetType(I.Type).NumScalars)
		{
			Values[I.Result] = Load(I.Operands[0]);
		}
		return;
	case OpStore:
		Store(I.Operands[0], Get(I.Operands[1]));
		return;
	case OpAccessChain:
	case OpInBoundsAccessChain:
		return;
	case OpFunctionCall:
		bDiscarded = true;
		return;
	case OpArrayLength:
	{
		const FSpirvVariable& Variable = *Module.FindVariable(I.Operands[0]);
		const FSpirvType& Type = Module.GetType(Variable.Type);
		const uint32_t Slot = Reflection.Slots.at(Variable.Id);
		const FKernelBuffer& Buffer = Type.Members[0].bNonWritable ? Args->Buffers[Slot] : Args->RWBuffers[Slot];
		Values[I.Result] = {Buffer.SizeInBytes / std::max(4u, Module.GetType(Module.GetMemberType(Variable.Type, I.Operands[1])).ArrayStride)};
		return;
	}
	case OpExtInst:
		ExecuteExtended(I, Result);
		break;
	default:
		if (!ExecuteComposite(I, Result) && !ExecuteMatrix(I, Result) && !ExecuteImage(I, Result))
		{
			for (uint32_t i = 0; i < Module.GetType(I.Type).NumScalars; ++i)
			{
				uint32_t Operands[3] = {};
				for (size_t k = 0; k < I.Operands.size() && k < 3; ++k)
				{
					const FScalars& Value = Get(I.Operands[k]);
					Operands[k] = Value[Value.size() == 1 ? 0 : i];
				}
				uint32_t Bits = 0;
				if (!EvaluateOperation(I.Op, Operands, Bits))
				{
					Module.Fail("the model does not know " + GetSpirvOpName(I.Op), &I);
				}
				Result.push_back(Bits);
			}
		}
		break;
	}
	if (I.Result)
	{
		Values[I.Result] = std::move(Result);
	}
}

void FSpirvInterpreterImpl::EnterBlock(const FSpirvBlock& Block, uint32_t From)
{
	// All phis of a block read before any of them is written.
	std::vector<std::pair<uint32_t, FScalars>> New;
	for (const FSpirvInstruction& I : Block.Instructions)
	{
		if (I.Op != OpPhi)
		{
			break;
		}
		for (size_t k = 0; k < I.Operands.size(); k += 2)
		{
			if (I.Operands[k + 1] == From)
			{
				New.emplace_back(I.Result, Get(I.Operands[k]));
				break;
			}
		}
	}
	for (auto& [Id, Value] : New)
	{
		Values[Id] = std::move(Value);
	}
}

uint32_t FSpirvInterpreterImpl::ChooseTarget(const FSpirvInstruction& Terminator)
{
	switch (Terminator.Op)
	{
	case OpBranch:
		return Terminator.Operands[0];
	case OpBranchConditional:
		return Terminator.Operands[Get(Terminator.Operands[0])[0] ? 1 : 2];
	case OpSwitch:
		for (size_t i = 2; i + 1 < Terminator.Operands.size(); i += 2)
		{
			if (Terminator.Operands[i] == Get(Terminator.Operands[0])[0])
			{
				return Terminator.Operands[i + 1];
			}
		}
		return Terminator.Operands[1];
	case OpKill:
		bDiscarded = true;
		return 0;
	default:
		return 0;
	}
}

FInterpretedPixel FSpirvInterpreterImpl::Run(const FKernelArgs& InArgs, int32_t X, int32_t Y, int32_t Z, uint64_t MaxSteps)
{
	Args = &InArgs;
	Position[0] = X;
	Position[1] = Y;
	Position[2] = Z;
	bDiscarded = false;
	Values.clear();
	Memory.clear();
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		const FSpirvConstant* Initial = Variable.Initializer ? Module.FindConstant(Variable.Initializer) : nullptr;
		if (!Variable.Initializer && Module.GetType(Variable.Type).NumScalars)
		{
			Memory[Variable.Id].assign(Module.GetType(Variable.Type).NumScalars, 0);
		}
		else if (Initial)
		{
			Memory[Variable.Id] = Initial->Scalars;
		}
	}
	uint64_t Steps = 0;
	const FSpirvBlock* Block = &Module.Blocks[0];
	while (Block && !bDiscarded)
	{
		for (const FSpirvInstruction& I : Block->Instructions)
		{
			if (++Steps > MaxSteps)
			{
				Module.Fail("the shader did not end", &I);
			}
			const bool bTerminator = I.Op >= OpBranch && I.Op <= OpUnreachable;
			if (I.Op != OpPhi && !bTerminator && !bDiscarded)
			{
				Execute(I);
			}
		}
		const uint32_t Target = bDiscarded ? 0 : ChooseTarget(Block->Terminator());
		const FSpirvBlock* const Next = Target ? &Module.GetBlock(Target) : nullptr;
		if (Next)
		{
			EnterBlock(*Next, Block->Label);
		}
		Block = Next;
	}
	FInterpretedPixel Pixel;
	Pixel.bDiscarded = bDiscarded;
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		for (uint32_t i = 0; Variable.Storage == StorageOutput && Variable.Location < 8 && i < 4 && i < Memory[Variable.Id].size(); ++i)
		{
			Pixel.Targets[Variable.Location][i] = ToFloat(Memory[Variable.Id][i]);
		}
	}
	return Pixel;
}

FSpirvInterpreter::FSpirvInterpreter(const FSpirvModule& Module, const FSpirvReflection& Reflection)
	: Impl(std::make_unique<FSpirvInterpreterImpl>(Module, Reflection))
{
}

FSpirvInterpreter::~FSpirvInterpreter() = default;

FInterpretedPixel FSpirvInterpreter::Run(const FKernelArgs& Args, int32_t X, int32_t Y, int32_t Z, uint64_t MaxSteps)
{
	return Impl->Run(Args, X, Y, Z, MaxSteps);
}

} // namespace Drydock
