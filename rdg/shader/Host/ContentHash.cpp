// Computes SHA-256. The constants are computed as the standard defines them: fractional parts of the roots of the first
// primes. Source: NIST FIPS 180-4, sections 4.1.2, 4.2.2, 5.3.3 and 6.2.
#include "ContentHash.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace Drydock
{

namespace
{

constexpr int NumRounds = 64;

struct FConstants
{
	std::array<uint32_t, NumRounds> Rounds{};
	std::array<uint32_t, 8> Initial{};

	FConstants()
	{
		int Count = 0;
		for (uint32_t Candidate = 2; Count < NumRounds; ++Candidate)
		{
			bool bPrime = true;
			for (uint32_t Divisor = 2; Divisor * Divisor <= Candidate; ++Divisor)
			{
				bPrime = bPrime && Candidate % Divisor != 0;
			}
			if (bPrime)
			{
				Rounds[size_t(Count)] = Fraction(Candidate, 3);
				if (Count < 8)
				{
					Initial[size_t(Count)] = Fraction(Candidate, 2);
				}
				++Count;
			}
		}
	}

	/** First 32 bits of the fraction of a square or cube root, exactly: the largest r with r^Degree <= Value * 2^(32
	 * Degree). */
	static uint32_t Fraction(uint32_t Value, int Degree)
	{
		uint64_t Root = 0;
		for (int Bit = 36; Bit >= 0; --Bit)
		{
			const uint64_t Try = Root | (uint64_t(1) << Bit);
			const unsigned __int128 Square = static_cast<unsigned __int128>(Try) * Try;
			const bool bFits = Degree == 2 ? Square <= static_cast<unsigned __int128>(Value) << 64
										   : Square <= ((static_cast<unsigned __int128>(Value) << 96) / Try);
			Root = bFits ? Try : Root;
		}
		return uint32_t(Root);
	}
};

const FConstants& GetConstants()
{
	static const FConstants Constants;
	return Constants;
}

} // namespace

FContentHash::FContentHash()
	: State(GetConstants().Initial)
	, Pending{}
{
}

void FContentHash::AddBlock(const uint8_t* Block)
{
	std::array<uint32_t, NumRounds> W;
	for (size_t i = 0; i < 16; ++i)
	{
		W[i] = uint32_t(Block[4 * i]) << 24 | uint32_t(Block[4 * i + 1]) << 16 | uint32_t(Block[4 * i + 2]) << 8 |
			   Block[4 * i + 3];
	}
	for (size_t i = 16; i < NumRounds; ++i)
	{
		const uint32_t S0 = std::rotr(W[i - 15], 7) ^ std::rotr(W[i - 15], 18) ^ (W[i - 15] >> 3);
		const uint32_t S1 = std::rotr(W[i - 2], 17) ^ std::rotr(W[i - 2], 19) ^ (W[i - 2] >> 10);
		W[i] = W[i - 16] + S0 + W[i - 7] + S1;
	}
	auto [A, B, C, D, E, F, G, H] = State;
	for (size_t i = 0; i < NumRounds; ++i)
	{
		const uint32_t S1 = std::rotr(E, 6) ^ std::rotr(E, 11) ^ std::rotr(E, 25);
		const uint32_t T1 = H + S1 + ((E & F) ^ (~E & G)) + GetConstants().Rounds[i] + W[i];
		const uint32_t S0 = std::rotr(A, 2) ^ std::rotr(A, 13) ^ std::rotr(A, 22);
		const uint32_t T2 = S0 + ((A & B) ^ (A & C) ^ (B & C));
		H = G;
		G = F;
		F = E;
		E = D + T1;
		D = C;
		C = B;
		B = A;
		A = T1 + T2;
	}
	const std::array<uint32_t, 8> Sum{A, B, C, D, E, F, G, H};
	for (size_t i = 0; i < 8; ++i)
	{
		State[i] += Sum[i];
	}
}

void FContentHash::AddBytes(const void* Bytes, size_t Count)
{
	const uint8_t* Next = static_cast<const uint8_t*>(Bytes);
	while (Count)
	{
		const size_t Used = size_t(Length % 64);
		const size_t Part = std::min(Count, 64 - Used);
		std::memcpy(Pending.data() + Used, Next, Part);
		Length += Part;
		Next += Part;
		Count -= Part;
		if (Length % 64 == 0)
		{
			AddBlock(Pending.data());
		}
	}
}

void FContentHash::Add(const std::string& Piece)
{
	const uint64_t Size = Piece.size();
	AddBytes(&Size, sizeof(Size));
	AddBytes(Piece.data(), Piece.size());
}

std::string FContentHash::Finish()
{
	const uint64_t Bits = Length * 8;
	const uint8_t One = 0x80;
	AddBytes(&One, 1);
	const uint8_t Zero = 0;
	while (Length % 64 != 56)
	{
		AddBytes(&Zero, 1);
	}
	for (int i = 7; i >= 0; --i)
	{
		const uint8_t Byte = uint8_t(Bits >> (8 * i));
		AddBytes(&Byte, 1);
	}
	std::string Result;
	for (const uint32_t Word : State)
	{
		for (int Shift = 28; Shift >= 0; Shift -= 4)
		{
			Result += "0123456789abcdef"[(Word >> Shift) & 15];
		}
	}
	return Result;
}

std::string HashBytes(const std::string& Bytes)
{
	FContentHash Hash;
	Hash.AddBytes(Bytes.data(), Bytes.size());
	return Hash.Finish();
}

} // namespace Drydock
